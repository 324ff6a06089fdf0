# SPDX-License-Identifier: BSD-3-Clause
"""The reference of the package in the documents is that of its docstrings."""

import difflib
import itertools
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import limn

ROOT = Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "colmap_ext/python/write_reference.py"
PAGE = ROOT / "colmap_ext/docs/python-reference.md"
PACKAGE = Path(limn.__file__).resolve().parent


class Reference(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, package):
        page = self.folder / "page.md"
        done = subprocess.run([sys.executable, SCRIPT, package, page], capture_output=True, text=True)
        return done, page

    def written(self):
        done, page = self.write(PACKAGE)
        self.assertEqual(done.returncode, 0, done.stderr)
        return page.read_text(encoding="utf-8")

    def test_page_is_that_of_the_docstrings(self):
        changes = difflib.unified_diff(PAGE.read_text(encoding="utf-8").splitlines(), self.written().splitlines(),
                                       "committed", "docstrings", lineterm="", n=0)
        first = "\n".join(itertools.islice(changes, 20))
        self.assertFalse(first, f"{first}\nrenew the page: {sys.executable} {SCRIPT} {PACKAGE} {PAGE}")

    def test_types_are_readable(self):
        for noise in ("_limn.", "numpy.", "typing.", "arg0", "object at"):
            self.assertNotIn(noise, self.written())

    def test_what_has_no_docstring_is_named(self):
        package = self.folder / "limn"
        package.mkdir()
        (package / "errors.py").write_text("")
        (package / "__init__.py").write_text("import limn.errors\n__all__ = ['draw']\ndef draw(path: str) -> None: ...\n")
        done, page = self.write(package)
        self.assertEqual(done.returncode, 1)
        self.assertIn("limn.draw: no docstring", done.stderr)
        self.assertFalse(page.exists())


if __name__ == "__main__":
    unittest.main()
