"""How a suite is run: what it prints and how it ends is told, and nothing that it began outlives it."""

import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import run_tests  # noqa: E402


def is_alive(process):
    """A process that ended may stand in the table until somebody asks for its status."""
    try:
        return Path(f"/proc/{process}/stat").read_text().split(")")[-1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


class Run(unittest.TestCase):
    def test_a_program_tells_its_status_and_what_it_printed(self):
        self.assertEqual(run_tests.run(["sh", "-c", "echo one; echo two >&2; exit 3"]), (3, "one\ntwo\n"))

    @unittest.skipUnless(Path("/proc/self").is_dir(), "needs /proc")
    def test_the_limit_ends_a_program_with_all_that_it_began(self):
        with tempfile.TemporaryDirectory() as folder:
            begun = time.monotonic()
            status, text = run_tests.run(["sh", "-c", "sleep 60 & echo $!; sleep 60"], folder=folder, limit=0.5)
            self.assertLess(time.monotonic() - begun, 30)
        self.assertIsNone(status)
        child = int(text)
        for _ in range(100):
            if not is_alive(child):
                break
            time.sleep(0.05)
        self.assertFalse(is_alive(child))


class Complaints(unittest.TestCase):
    def test_what_no_test_announced_is_told_and_what_was_announced_must_come(self):
        text = "EXPECTED MESSAGE: a\nERROR: a\nWARNING: b\nEXPECTED MESSAGE: c\nfine\n"
        self.assertEqual(run_tests.complaints(text), ["WARNING: b", "expected, and not seen: c"])


if __name__ == "__main__":
    unittest.main()
