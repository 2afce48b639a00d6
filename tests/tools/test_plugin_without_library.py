"""A project that has the addon's files but not its library: the editor shows one message, and no parse error."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = re.compile(r"res://addons/pcg/bin/libpcg\.\w+\.template_debug\.\w+\.\w+")


@unittest.skipUnless(os.environ.get("GODOT"), "GODOT names no engine")
class PluginWithoutLibrary(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Path(folder.name) / "project"
        leave_out = shutil.ignore_patterns("bin", "pcg.gdextension*")
        shutil.copytree(ROOT / "addons/pcg", self.project / "addons/pcg", ignore=leave_out)
        (self.project / "project.godot").write_text(
            'config_version=5\n[application]\nconfig/name="A game"\n'
            '[editor_plugins]\nenabled=PackedStringArray("res://addons/pcg/plugin.cfg")\n')

    def open_editor(self):
        """Returns everything that the engine prints while it opens the project in the editor and closes it."""
        command = [os.environ["GODOT"], "--headless", "--editor", "--path", str(self.project), "--quit"]
        home = str(self.project.parent / "home")
        environment = {**os.environ, "XDG_DATA_HOME": home, "XDG_CONFIG_HOME": home, "XDG_CACHE_HOME": home}
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def assert_one_message(self, printed, *words):
        messages = [line for line in printed.splitlines() if "PCG for Godot:" in line]
        self.assertEqual(len(messages), 1, printed)
        for word in words:
            self.assertIn(word, messages[0])
        self.assertNotIn("Parse Error", printed)
        self.assertNotIn("SCRIPT ERROR", printed)

    def test_without_manifest_one_message_says_what_is_missing_and_what_to_do(self):
        self.assert_one_message(self.open_editor(), "there is no res://addons/pcg/pcg.gdextension", "release zip")

    def test_with_manifest_and_no_library_the_message_names_the_expected_file(self):
        shutil.copy(ROOT / "addons/pcg/pcg.gdextension", self.project / "addons/pcg")
        printed = self.open_editor()
        self.assert_one_message(printed, "missing")
        self.assertRegex(printed, LIBRARY)

    def test_with_a_library_that_cannot_be_loaded_the_message_says_that_it_is_there(self):
        manifest = (ROOT / "addons/pcg/pcg.gdextension").read_text()
        shutil.copy(ROOT / "addons/pcg/pcg.gdextension", self.project / "addons/pcg")
        (self.project / "addons/pcg/bin").mkdir()
        for library in re.findall(r"addons/pcg/bin/[\w.]+", manifest):
            (self.project / library).write_bytes(b"not a library")
        self.assert_one_message(self.open_editor(), "is there but was not loaded; it is damaged, or was not built for Linux")

    def test_with_a_library_for_a_newer_engine_the_message_says_which(self):
        manifest = (ROOT / "addons/pcg/pcg.gdextension").read_text()
        newer = re.sub(r'compatibility_minimum *= *"[\d.]+"', 'compatibility_minimum = "4.99"', manifest)
        self.assertNotEqual(newer, manifest)
        (self.project / "addons/pcg/pcg.gdextension").write_text(newer)
        (self.project / "addons/pcg/bin").mkdir()
        for library in re.findall(r"addons/pcg/bin/[\w.]+", manifest):
            (self.project / library).write_bytes(b"not a library")
        self.assert_one_message(self.open_editor(), "it needs Godot 4.99 or newer, and this is Godot 4.")


if __name__ == "__main__":
    unittest.main()
