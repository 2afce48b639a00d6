"""Every example of the two languages in the docs is a whole file that loads without an error or a warning."""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "bin/pcg"
DOCUMENTS = {"docs/cga-by-example.md": ("cga", "rules/cga"), "docs/agenda-by-example.md": ("pcg", "rules/agenda")}


@unittest.skipUnless(PROGRAM.is_file(), "needs bin/pcg")
class Examples(unittest.TestCase):
    def check(self, example, language, beside):
        with tempfile.TemporaryDirectory() as folder:
            for neighbor in (ROOT / beside).iterdir():  # files that it imports, and their pictures
                (Path(folder) / neighbor.name).symlink_to(neighbor)
            file = Path(folder) / f"example.{language}"
            file.write_text(example)
            done = subprocess.run([PROGRAM, "check", file], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ""), example)

    def test_they_load(self):
        for document, (language, beside) in DOCUMENTS.items():
            examples = re.findall(rf"```{language}\n(.*?)```", (ROOT / document).read_text(), re.DOTALL)
            self.assertGreater(len(examples), 5, document)
            for number, example in enumerate(examples, 1):
                with self.subTest(document=document, example=number):
                    self.assertIn("@StartRule", example)
                    self.check(example, language, beside)


if __name__ == "__main__":
    unittest.main()
