"""The Asset Library's zip holds the addon alone, and the same files give the same bytes."""

import os
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import package  # noqa: E402


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.saved = package.ROOT, package.ADDON
        package.ROOT, package.ADDON = self.root, self.root / "addons/pcg"
        self.addCleanup(self.restore)
        for name in ("README.md", "LICENSE.md", "project.godot", "addons/pcg/plugin.cfg", "addons/pcg/bin/libpcg.x.so"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(name)

    def restore(self):
        package.ROOT, package.ADDON = self.saved

    def test_it_holds_the_addon_with_readme_and_licence_and_nothing_else(self):
        package.write_package(self.root / "out/a.zip")
        with zipfile.ZipFile(self.root / "out/a.zip") as archive:
            self.assertEqual(archive.namelist(), ["addons/pcg/" + name for name in
                             ("LICENSE.md", "README.md", "bin/libpcg.x.so", "plugin.cfg")])

    def test_the_time_of_the_files_does_not_change_a_byte(self):
        package.write_package(self.root / "out/a.zip")
        os.utime(self.root / "addons/pcg/plugin.cfg", (1, 1))
        package.write_package(self.root / "out/b.zip")
        self.assertEqual((self.root / "out/a.zip").read_bytes(), (self.root / "out/b.zip").read_bytes())


if __name__ == "__main__":
    unittest.main()
