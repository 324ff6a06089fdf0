# SPDX-License-Identifier: BSD-3-Clause
"""Checks documents against the tree: every link between them, every section of the algorithm that a comment cites, and every file
that a page of the algorithm names exists."""

import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "src" / "limn" / "algorithm"
FOLDERS = ("src", "colmap_ext", "tests", "scripts", "datasets")


def tracked_files():
    """All files of the repository, or, in a copy without history, all that are not built."""
    try:
        names = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
        return [ROOT / name for name in names if name and (ROOT / name).is_file()]
    except (OSError, subprocess.CalledProcessError):
        files = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file()]
        return [*files, ROOT / "README.md"]


FILES = tracked_files()


def anchors(page):
    """The anchors of the headings of a page, as GitHub makes them."""
    titles = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w -]", "", title.lower()).strip().replace(" ", "-") for title in titles}


def missing(page, anchor):
    """What is wrong with a reference, or nothing."""
    if not page.exists():
        return "no such file"
    if anchor and anchor not in anchors(page):
        return "no such section"
    return None


class Documents(unittest.TestCase):
    def assert_found(self, references):
        """`references`: place, page and anchor, each."""
        wrong = [f"{place}: {page.name}#{anchor}: {missing(page, anchor)}" for place, page, anchor in references
                 if missing(page, anchor)]
        self.assertEqual(wrong, [])

    def test_links_between_documents(self):
        links = []
        for document in (path for path in FILES if path.suffix == ".md"):
            for target in re.findall(r"\]\(([^)\s]+)\)", document.read_text()):
                if "://" in target or target.startswith("mailto:"):
                    continue
                name, _, anchor = target.partition("#")
                page = (document.parent / name).resolve() if name else document
                links.append((document.relative_to(ROOT), page, anchor if page.suffix == ".md" else ""))
        self.assertGreater(len(links), 100)
        self.assert_found(links)

    def test_sections_that_code_cites(self):
        citations = []
        for path in (path for path in FILES if path.suffix in (".h", ".cc", ".py", ".sh", ".js", ".txt")):
            for name, anchor in re.findall(r"\balgorithm/(\w+\.md)(?:#([\w-]+))?", path.read_text()):
                citations.append((path.relative_to(ROOT), PAGES / name, anchor))
        self.assertGreater(len(citations), 50)
        self.assert_found(citations)

    def test_files_that_pages_name(self):
        """"Files: `module/name`, `other_name` of the same module"."""
        known = {path.relative_to(ROOT / "src/limn").with_suffix("").as_posix() for path in FILES
                 if path.is_relative_to(ROOT / "src/limn")}
        wrong, count = [], 0
        for page in sorted(PAGES.glob("*.md")):
            for names in re.findall(r"Files?:((?:\s*`[^`]+`[,;.]?|\s+and|\s+of updates)+)", page.read_text()):
                module = ""
                for name in re.findall(r"`([^`]+)`", names):
                    count += 1
                    module = name.partition("/")[0] if "/" in name else module
                    whole = (name if "/" in name else f"{module}/{name}").removesuffix(".h")
                    found = (ROOT / "src/limn" / whole).is_dir() if whole.endswith("/") else whole in known
                    if not found:
                        wrong.append(f"{page.name}: {whole}")
        self.assertGreater(count, 50)
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
