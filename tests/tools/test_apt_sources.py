"""The machine's own apt configuration, in both of its forms, gives the mirror; nothing else does."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from apt_sources import Mirror, read_mirrors  # noqa: E402


class AptSources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.etc = Path(folder.name)
        (self.etc / "sources.list.d").mkdir()
        self.keyring = self.etc / "debian.gpg"
        self.keyring.touch()

    def write(self, name, text):
        (self.etc / name).write_text(text.replace("KEYRING", str(self.keyring)))

    def test_deb822_gives_uri_and_keyring_and_skips_what_is_disabled_or_source_only(self):
        self.write("sources.list.d/debian.sources", (
            "# a comment\nTypes: deb deb-src\nURIs: http://a.example/debian\n  http://b.example/debian\n"
            "Suites: bookworm\nComponents: main\nSigned-By: KEYRING\n\n"
            "Types: deb\nEnabled: no\nURIs: http://off.example/debian\nSuites: x\nComponents: main\n\n"
            "Types: deb-src\nURIs: http://source.example/debian\nSuites: x\nComponents: main\n"))
        self.assertEqual(read_mirrors(self.etc), [Mirror("http://a.example/debian", str(self.keyring)),
                                                  Mirror("http://b.example/debian", str(self.keyring))])

    def test_one_line_entries_with_and_without_options(self):
        self.write("sources.list", (
            "deb [arch=amd64 signed-by=KEYRING] http://a.example/debian bookworm main contrib\n"
            "# deb http://off.example/debian bookworm main\ndeb-src http://source.example/debian bookworm main\n"
            "deb http://b.example/debian bookworm main # the other\n"))
        self.assertEqual(read_mirrors(self.etc),
                         [Mirror("http://a.example/debian", str(self.keyring)), Mirror("http://b.example/debian", "")])

    def test_security_archives_and_repeated_and_foreign_files_are_left_out(self):
        self.write("sources.list", "deb http://a.example/debian-security x main\ndeb http://a.example/debian y main\n")
        self.write("sources.list.d/more.list", "deb http://a.example/debian z main\n")
        self.write("sources.list.d/old.list.disabled", "deb http://off.example/debian z main\n")
        self.assertEqual(read_mirrors(self.etc), [Mirror("http://a.example/debian", "")])

    def test_a_key_written_into_the_stanza_or_missing_is_left_to_the_machine(self):
        self.write("sources.list.d/x.sources", (
            "Types: deb\nURIs: http://a.example/debian\nSuites: x\nComponents: main\n"
            "Signed-By:\n -----BEGIN PGP PUBLIC KEY BLOCK-----\n .\n abc\n"))
        self.write("sources.list", "deb [signed-by=/nowhere/key.gpg] http://b.example/debian x main\n")
        self.assertEqual(read_mirrors(self.etc),
                         [Mirror("http://b.example/debian", ""), Mirror("http://a.example/debian", "")])

    def test_no_configuration_at_all_gives_no_mirror(self):
        self.assertEqual(read_mirrors(self.etc / "nowhere"), [])


if __name__ == "__main__":
    unittest.main()
