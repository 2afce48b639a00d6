"""The front door says what is wrong and what to do, where it cannot do it by itself."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Dev(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def dev(self, *arguments, **environment):
        return subprocess.run([ROOT / "dev", *arguments], capture_output=True, text=True, check=False, timeout=60,
                              stdin=subprocess.DEVNULL, env={**os.environ, **environment})

    def machine_without(self, missing, user):
        """A PATH with the few commands that ./dev itself calls, less `missing`, for a user with that number."""
        for name in ("bash", "env", "readlink", "dirname", "mkdir", "xargs", "echo", "g++", "scons", "ccache", "python3"):
            if name != missing:
                (self.folder / name).symlink_to(shutil.which(name))
        for name, answer in (("id", user), ("apt-get", "")):
            (self.folder / name).write_text(f"#!{shutil.which('bash')}\necho {answer}\n")
            (self.folder / name).chmod(0o755)
        return str(self.folder)

    def test_help_names_every_command(self):
        shown = self.dev("help")
        self.assertEqual(shown.returncode, 0)
        for command in ("run", "test", "editor", "bench", "fuzz", "soak", "docs", "package", "windows", "export",
                        "godot-cpp", "setup"):
            self.assertIn(f"./dev {command}", shown.stdout)

    def test_an_unknown_command_is_named_and_the_others_are_listed(self):
        shown = self.dev("fly")
        self.assertEqual(shown.returncode, 1)
        self.assertIn("no command 'fly'", shown.stderr)
        self.assertIn("./dev run", shown.stderr)

    def test_without_root_a_missing_package_is_answered_with_the_line_that_installs_it(self):
        shown = self.dev("setup", PATH=self.machine_without("scons", 1000))
        self.assertEqual(shown.returncode, 1)
        self.assertIn("sudo apt-get install scons\n", shown.stderr)

    def test_an_engine_that_does_not_run_ends_it_with_one_line(self):
        shown = self.dev("setup", GODOT="/nowhere/godot")
        self.assertEqual(shown.returncode, 1)
        self.assertIn("GODOT=/nowhere/godot does not run", shown.stderr)
        self.assertNotIn("Traceback", shown.stderr)


if __name__ == "__main__":
    unittest.main()
