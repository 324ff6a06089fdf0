#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_includes.py refuses loops between rooms, ways around doors, and POSIX outside two folders."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

import check_includes  # noqa: E402


def loops(files):
    """The loops of a tree with these files: path -> what it includes."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, includes in files.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("".join(f'#include "{include}"\n' for include in includes), encoding="utf-8")
        return list(check_includes.loops(check_includes.rooms_of(root, [root / name for name in files])))


class Loops(unittest.TestCase):
    def test_a_source_and_its_header_are_one_room(self):
        self.assertEqual(loops({"src/limn/a/x.h": [], "src/limn/a/x.cc": ["limn/a/x.h"]}), [])

    def test_what_two_share_is_no_loop(self):
        self.assertEqual(loops({"src/limn/a/x.h": ["limn/a/y.h", "limn/a/z.h"], "src/limn/a/y.h": ["limn/a/z.h"],
                                "src/limn/a/z.h": []}), [])

    def test_a_source_that_includes_what_includes_its_header(self):
        self.assertEqual(loops({"src/limn/a/x.h": [], "src/limn/a/x.cc": ["limn/a/x.h", "limn/a/y.h"],
                                "src/limn/a/y.h": ["limn/a/x.h"]}),
                         ["a loop of includes: limn/a/x -> limn/a/y -> limn/a/x"])

    def test_across_folders_the_shortest_way_round_is_told(self):
        found = loops({"src/limn/a/x.h": ["limn/a/y.h", "limn/b/z.h"], "src/limn/a/y.h": ["limn/b/z.h"],
                       "src/limn/b/z.h": ["limn/a/x.h"], "src/limn/b/other.h": ["limn/a/x.h"]})
        self.assertEqual(found, ["a loop of includes: limn/a/x -> limn/b/z -> limn/a/x",
                                 "a loop of includes: limn/a/y -> limn/b/z -> limn/a/x -> limn/a/y"])

    def test_every_loop_is_told(self):
        found = loops({"colmap_ext/a/x.h": ["colmap_ext/a/y.h"], "colmap_ext/a/y.h": ["colmap_ext/a/x.h"],
                       "src/limn/b/x.h": ["limn/b/y.h"], "src/limn/b/y.h": ["limn/b/x.h"]})
        self.assertEqual(len(found), 2)


class Doors(unittest.TestCase):
    def test_a_folder_is_entered_by_its_door(self):
        inside, door = "limn/formats/svg/path.h", "limn/formats/svg/svg_drawing_writer.h"
        self.assertIsNotNone(check_includes.door_problem("src/limn/formats/write_drawing.cc", inside))
        self.assertIsNotNone(check_includes.door_problem("colmap_ext/verbs/export.cc", inside))
        self.assertIsNone(check_includes.door_problem("src/limn/formats/write_drawing.cc", door))
        self.assertIsNone(check_includes.door_problem("src/limn/formats/svg/link.cc", inside))


class Posix(unittest.TestCase):
    def problem(self, path, target):
        return check_includes.third_party_problem(path, target)

    def test_is_for_sources_of_two_folders(self):
        for target in ("unistd.h", "sys/stat.h", "csignal"):
            self.assertIsNone(self.problem("src/limn/files/output_lock.cc", target))
            self.assertIsNone(self.problem("colmap_ext/host/interrupt.cc", target))
            for path in ("src/limn/util/options.cc", "colmap_ext/workspace/layout.cc", "colmap_ext/main.cc",
                         "colmap_ext/python/module.cc"):
                self.assertIn("colmap_ext/host/", self.problem(path, target))

    def test_is_in_no_header(self):
        self.assertIn("sources", self.problem("src/limn/files/output_lock.h", "unistd.h"))
        self.assertIn("sources", self.problem("colmap_ext/host/interrupt.h", "csignal"))

    def test_headers_of_the_language_with_similar_names_are_not_meant(self):
        for target in ("semaphore", "system_error", "cstring", "cerrno", "filesystem"):
            self.assertIsNone(self.problem("src/limn/model/view.h", target))

    def test_is_told_with_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "colmap_ext/verbs/align.cc"
            source.parent.mkdir(parents=True)
            source.write_text("#include <string>\n# include <sys/stat.h>\n", encoding="utf-8")
            found = list(check_includes.problems_of_file(Path(folder), source))
        self.assertEqual(found, ["colmap_ext/verbs/align.cc:2: <sys/stat.h> belongs to src/limn/files/, colmap_ext/host/"])


if __name__ == "__main__":
    unittest.main()
