"""The bindings' builder of class help: a source that holds the pages, compressed as the engine unpacks them."""

import re
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings"))
from generator import documentation  # noqa: E402


class Documentation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.pages = [self.folder / "A.xml", self.folder / "B.xml"]
        for page, text in zip(self.pages, ('<class name="A"></class>\n', '<class name="B">Straße</class>\n' * 40)):
            page.write_text(text, encoding="utf-8")

    def write(self, name):
        documentation.write_source(self.folder / name, self.pages)
        return (self.folder / name).read_text()

    def test_the_source_holds_all_pages_and_says_how_long_they_are(self):
        source = self.write("doc.cpp")
        numbers = re.search(r"pages\[\] = \{(.*?)\}", source, re.DOTALL)[1]
        packed = bytes(int(number) for number in re.findall(r"\d+", numbers))
        text = b"".join(page.read_bytes() for page in self.pages)
        self.assertEqual(zlib.decompress(packed), text)
        self.assertRegex(source, rf'DocDataRegistration registration\("\w+", {len(text)}, {len(packed)}, pages\);')

    def test_the_same_pages_give_the_same_source(self):
        self.assertEqual(self.write("one.cpp"), self.write("other.cpp"))


if __name__ == "__main__":
    unittest.main()
