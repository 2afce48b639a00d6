"""demo/run.gd: a day with its files, and one message for each way in which its input can be wrong."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SMALL = ("--lots", "20", "--persons", "20")
WRITTEN = ("heatmap.png", "persons.csv", "city.glb")


@unittest.skipUnless(os.environ.get("GODOT"), "needs an engine in $GODOT")
class DemoRun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"

    def run_demo(self, *arguments):
        command = [os.environ["GODOT"], "--headless", "--path", ".", "--script", "demo/run.gd", "--", *SMALL, "--out", self.out, *arguments]
        return subprocess.run([str(part) for part in command], cwd=ROOT, capture_output=True, text=True, errors="replace",
                              check=False, timeout=240, stdin=subprocess.DEVNULL)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def assert_refused(self, shown, *words):
        """Exit status 1, a message that holds `words`, told once, nothing written, and no complaint of the engine about itself."""
        self.assertEqual(shown.returncode, 1, shown.stdout + shown.stderr)
        for word in words:
            self.assertIn(word, shown.stderr)
        self.assertLessEqual(len(re.findall(r"\berror:", shown.stderr)), 1, shown.stderr)
        self.assertNotIn("SCRIPT ERROR", shown.stderr)
        self.assertNotIn("leaked", shown.stderr)
        self.assertFalse(self.out.exists() and any(self.out.iterdir()))

    def test_a_small_day_is_lived_told_and_written(self):
        shown = self.run_demo()
        self.assertEqual(shown.returncode, 0, shown.stdout + shown.stderr)
        self.assertEqual(shown.stderr.strip(), "")
        self.assertRegex(shown.stdout, r"city: 20 lots")
        self.assertRegex(shown.stdout, r"\d+ trips")
        self.assertRegex(shown.stdout, r"\d\d:\d\d \w+ .*leaves home")
        broken = re.search(r"broken promises: (.*)", shown.stdout)
        self.assertTrue(broken and all(part.endswith(" 0") for part in broken[1].split(", ")), shown.stdout)
        self.assertEqual(sorted(os.listdir(self.out)), sorted(WRITTEN))
        self.assertTrue((self.out / "heatmap.png").read_bytes().startswith(b"\x89PNG"))
        self.assertTrue((self.out / "city.glb").read_bytes().startswith(b"glTF"))

    def test_the_same_seed_gives_the_same_day(self):
        self.run_demo("--seed", "3")
        first = (self.out / "persons.csv").read_bytes()
        self.run_demo("--seed", "3")
        self.assertEqual((self.out / "persons.csv").read_bytes(), first)

    def test_missing_files_are_named(self):
        self.assert_refused(self.run_demo("--rules", self.folder / "none.pcg"), "none.pcg", "there is no such file")
        self.assert_refused(self.run_demo("--households", self.folder / "none.csv"), "none.csv", "there is no such file")

    def test_an_empty_a_binary_and_a_huge_rule_file_are_refused(self):
        self.assert_refused(self.run_demo("--rules", self.write("empty.pcg", "")), "empty.pcg")
        self.assert_refused(self.run_demo("--rules", self.write("binary.pcg", bytes(range(256)) * 64)), "binary.pcg")
        brackets = self.run_demo("--rules", self.write("brackets.pcg", "@StartRule\nA --> " + "[" * 10_000_000))
        self.assertEqual(brackets.returncode, 1)
        self.assertRegex(brackets.stderr, r"brackets\.pcg:2:\d+: error:")

    def test_an_unknown_name_has_line_column_and_a_suggestion(self):
        path = self.write("typo.pcg", "@StartRule\nHousehold --> members { true: stayInsid(0h, 24h, home) }\n")
        self.assert_refused(self.run_demo("--rules", path), "typo.pcg:2:31: error:", "stayInside")

    def test_a_file_that_imports_itself_is_refused(self):
        path = self.write("self.pcg", 'import other : "self.pcg"\n@StartRule\nHousehold --> members { true: stayInside(0h, 24h, home) }\n')
        self.assert_refused(self.run_demo("--rules", path), "self.pcg:1:")

    def test_bad_rows_of_households_are_named(self):
        for row, what in (("one adult,-5", "negative"), ("one adult,many", "words for a number"), ("three purple cats,4", "unknown words")):
            with self.subTest(what):
                path = self.write("bad.csv", f"descriptor,count\n{row}\n")
                self.assert_refused(self.run_demo("--households", path), "bad.csv:2:")
        self.assert_refused(self.run_demo("--households", self.write("none.csv", "descriptor,count\n")), "none.csv")

    def test_wrong_options_are_named(self):
        self.assert_refused(self.run_demo("--lots", "0"), "--lots wants 1 or more")
        self.assert_refused(self.run_demo("--persons", "many"), '--persons wants a whole number, not "many"')
        self.assert_refused(self.run_demo("--fly", "1"), "unknown option --fly", "usage:")
        self.assert_refused(self.run_demo("--seed"), "--seed wants a value")

    def test_a_folder_that_cannot_be_written_is_one_message(self):
        shown = self.run_demo("--out", "/proc/nowhere")
        self.assertEqual(shown.returncode, 1)
        self.assertEqual(shown.stderr.count("cannot make the folder"), 1, shown.stderr)


if __name__ == "__main__":
    unittest.main()
