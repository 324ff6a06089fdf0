#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_spdx.py finds missing, wrong and doubled license tags, and adds missing ones where they belong."""

import ast
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

import check_spdx  # noqa: E402

TAG = "SPDX-License-Identifier: BSD-3-Clause"


def written(name, content):
    """(exit code, content, printed text) after --write."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(content.encode())
        run = subprocess.run([SCRIPTS / "check_spdx.py", "--write", folder], capture_output=True, text=True, check=False)
        return run.returncode, path.read_bytes().decode(), run.stdout


def problem_of(name, content):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_text(content, encoding="utf-8")
        return check_spdx.problem(path)


class Writing(unittest.TestCase):
    def test_every_kind_of_file(self):
        for name, before, after in (
                ("a.cc", "#include <a>\n", f"// {TAG}\n#include <a>\n"),
                ("a.h", "", f"// {TAG}\n"),
                ("a.h.in", "", f"// {TAG}\n"),
                ("a.mjs", "#!/usr/bin/env node\nrun();\n", f"#!/usr/bin/env node\n// {TAG}\nrun();\n"),
                ("a.sh", "#!/bin/sh\n# What\n", f"#!/bin/sh\n# {TAG}\n# What\n"),
                ("CMakeLists.txt", "# What\n", f"# {TAG}\n# What\n"),
                ("a.css", "a {}\n", f"/* {TAG} */\na {{}}\n"),
                ("a.html", "<!doctype html>\n<html>\n", f"<!doctype html>\n<!-- {TAG} -->\n<html>\n"),
                ("b.html", "<p>\n", f"<!-- {TAG} -->\n<p>\n"),
                ("a.py", "# -*- coding: latin-1 -*-\nx = 1\n", f"# -*- coding: latin-1 -*-\n# {TAG}\nx = 1\n"),
                ("a.ts", "a;\r\nb;\r\n", f"// {TAG}\r\na;\r\nb;\r\n")):
            code, content, _ = written(name, before)
            self.assertEqual((code, content), (0, after), name)
            self.assertIsNone(problem_of(name, after), name)
            self.assertEqual(written(name, after)[1], after, f"{name}, again")

    def test_docstrings_stay(self):
        _, content, _ = written("a.py", '#!/usr/bin/env python3\n"""What it is."""\n')
        self.assertEqual(ast.get_docstring(ast.parse(content)), "What it is.")

    def test_other_files_have_none(self):
        code, content, output = written("notes.txt", "words\n")
        self.assertEqual((code, content, output), (1, "words\n", "0 files, 0 tags added, 0 problems\n"))

    def test_a_wrong_tag_is_told_and_left(self):
        before = "// SPDX-License-Identifier: MIT\nint a;\n"
        code, content, output = written("a.cc", before)
        self.assertEqual((code, content), (1, before))
        self.assertIn("a.cc: has another tag", output)


class Checking(unittest.TestCase):
    def test_problems(self):
        for name, content, expected in (
                ("a.cc", "int a;\n", "has no tag"),
                ("a.cc", f"// {TAG}\n// {TAG}\n", "has the tag twice"),
                ("a.sh", f"#!/bin/sh\n# {TAG}\n", None),
                ("a.sh", f"#!/bin/sh\n# {TAG}\n# {TAG}\n", "has the tag twice"),
                ("a.py", f'TEXT = "{TAG}"\n', "has no tag")):
            self.assertEqual(problem_of(name, content), expected, content)
        self.assertIn("elsewhere", problem_of("a.cc", f"int a;\n// {TAG}\n"))

    def test_only_tracked_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("known.py", "unknown.py", "data.json"):
                (Path(folder) / name).write_text("", encoding="utf-8")
            subprocess.run(["git", "init", "--quiet", folder], check=True)
            subprocess.run(["git", "-C", folder, "add", "known.py", "data.json"], check=True)
            self.assertEqual([path.name for path in check_spdx.source_files(Path(folder))], ["known.py"])


if __name__ == "__main__":
    unittest.main()
