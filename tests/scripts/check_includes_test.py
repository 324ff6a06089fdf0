#!/usr/bin/env python3
"""scripts/check_includes.py refuses loops between rooms, and ways around doors."""

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


if __name__ == "__main__":
    unittest.main()
