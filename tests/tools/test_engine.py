"""Which engine is taken, and what is said when none can be: against stand-ins, without a network."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Engine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def stand_in(self, name, version):
        path = self.folder / name
        path.write_text(f"#!/bin/sh\necho {version}\n")
        path.chmod(0o755)
        return str(path)

    def find(self, **environment):
        """Runs `engine.py path` with only the given variables, and no way to fetch anything."""
        clean = {"PATH": "/usr/bin:/bin", "PCG_ENGINE_DIR": "/proc/nowhere", **environment}
        return subprocess.run([sys.executable, ROOT / "tools/engine.py", "path"], capture_output=True, text=True,
                              env=clean, check=False, timeout=60)

    def test_the_variable_comes_first(self):
        named = self.stand_in("mine", "4.7.stable")
        self.stand_in("godot4", "4.6.stable")
        self.assertEqual(self.find(GODOT=named, PATH=f"{self.folder}:/usr/bin:/bin").stdout.strip(), named)

    def test_a_named_engine_that_is_too_old_or_does_not_run_is_an_error_that_says_so(self):
        old = self.find(GODOT=self.stand_in("old", "4.5.1.stable"))
        self.assertEqual(old.returncode, 1)
        self.assertIn("4.6 or newer", old.stderr)
        gone = self.find(GODOT="/nowhere/godot")
        self.assertEqual(gone.returncode, 1)
        self.assertIn("does not run", gone.stderr)

    def test_path_is_searched_and_an_old_one_there_is_passed_over(self):
        self.stand_in("godot4", "4.5.stable")
        new = self.stand_in("godot", "4.10.stable")
        self.assertEqual(self.find(PATH=f"{self.folder}:/usr/bin:/bin").stdout.strip(), new)

    def test_a_folder_that_cannot_be_written_is_named(self):
        found = self.find()
        self.assertEqual(found.returncode, 1)
        self.assertIn("PCG_ENGINE_DIR", found.stderr)
        self.assertNotIn("Traceback", found.stderr)

    def test_a_fetch_without_a_network_leaves_nothing_that_looks_finished(self):
        tools = self.folder / "bin"
        tools.mkdir()
        for name in ("dpkg", "dpkg-deb", "python3"):
            (tools / name).symlink_to(sys.executable)
        (tools / "apt-get").write_text("#!/bin/sh\necho 'E: Could not resolve host' >&2\nexit 100\n")
        (tools / "apt-get").chmod(0o755)
        found = self.find(PATH=str(tools), PCG_ENGINE_DIR=str(self.folder / "engine"))
        self.assertEqual(found.returncode, 1)
        self.assertNotIn("Traceback", found.stderr)
        self.assertIn("set GODOT", found.stderr)
        self.assertEqual(os.listdir(self.folder / "engine"), ["lock"])


if __name__ == "__main__":
    unittest.main()
