# SPDX-License-Identifier: BSD-3-Clause
"""Tests of scripts/bench/pose_ladder.py: which cases it runs and what its tables show."""

import argparse
import importlib.util
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/bench"))
sys.dont_write_bytecode = True

import pose_ladder as ladder  # noqa: E402


def cases_of(name, errors=()):
    return ladder.cases_of(name, argparse.Namespace(errors=list(errors), seeds=["1", "2"]))


def run(way, error="0", f=None, **more):
    return {"set": "room", "error": error, "seed": "1", "refine_cameras": way, "f_1": f, "f_2": f, "unit": "footprint",
            "tau_1": 1, "tau_2": 2, **more}


class Cases(unittest.TestCase):
    def test_exact_cameras_come_first_and_have_one_seed(self):
        self.assertEqual(cases_of("room", ["1", "0"]), [("0", "1"), ("1", "1"), ("1", "2")])

    def test_models_are_those_of_the_set(self):
        self.assertEqual(cases_of("bench"), [("0", "1"), ("sparse-sfm", "1"), ("sparse-rough", "1"), ("scale-0.5", "1"), ("scale-2", "1")])
        self.assertEqual(cases_of("room", ["sparse-sfm"]), [("0", "1")])
        self.assertEqual(cases_of("herz-jesu-p8"), [("0", "1"), ("colmap-SIMPLE_PINHOLE", "1"), ("colmap-SIMPLE_RADIAL", "1")])
        self.assertEqual(cases_of("room", ["colmap-SIMPLE_RADIAL", "turned"]),
                         [("0", "1"), ("colmap-SIMPLE_RADIAL", "1"), ("turned", "1"), ("turned", "2")])

    def test_results_of_another_commit_are_not_taken(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "refine-0.json"
            self.assertIsNone(ladder.stored(path, "a"))
            path.write_text('{"commit": "a"}', encoding="utf-8")
            self.assertEqual(ladder.stored(path, "a"), {"commit": "a"})
            self.assertIsNone(ladder.stored(path, "b"))


# Like tests/bench/pose_noise: refuses a folder where the images are.
POSE_NOISE = """#!/bin/sh
while [ "$1" != --output_path ]; do shift; done
mkdir -p "$2" && ln -s "$(dirname "$0")/originals" "$2/images"
"""


class Workspaces(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("cv2"), "python3-opencv is not installed")
    def test_other_sizes_are_made_again(self):
        import cv2
        import numpy
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "originals").mkdir()
            cv2.imwrite(str(folder / "originals/a.png"), numpy.zeros((30, 41, 3), numpy.uint8))
            (folder / "pose_noise").write_text(POSE_NOISE, encoding="utf-8")
            (folder / "pose_noise").chmod(0o755)
            arguments = argparse.Namespace(pose_noise=folder / "pose_noise", data_path=folder)
            for _ in range(2):
                ladder.make_workspace(arguments, "room", "scale-0.5", "1", folder / "out")
                self.assertEqual(cv2.imread(str(folder / "out/images/a.png")).shape, (15, 21, 3))
            self.assertEqual(cv2.imread(str(folder / "originals/a.png")).shape, (30, 41, 3))


class Tables(unittest.TestCase):
    def test_ways_are_beside_each_other(self):
        exact = [run("0", f=0.8), run("auto", f=0.8)]
        wrong = [run("0", "1", 0.2, rotation_px=1.6, refined=False), run("auto", "1", 0.6, rotation_px=0.1, refined=True)]
        table = ladder.markdown([exact, wrong])
        self.assertIn("F at 1 px | F at 2 px", table)
        self.assertIn("| 1 px | 1 | 20.0 / 60.0 | 20.0 / 60.0 | 75.0 | - / - | 1.6 / 0.1 |", table)
        self.assertIn("| no / yes | - / - |", table)

    def test_sizes_are_drawn_in_one_way(self):
        table = ladder.markdown([[run("auto", f=0.8)], [run("auto", "scale-2", 0.6, links=12, refined=False, cpu_seconds=7)]])
        self.assertIn("| scale-2 | 1 | 60.0 | 60.0 | 75.0 |", table)
        self.assertIn("| no | 12 | 7 |", table)

    def test_failures_are_empty(self):
        failed = {"set": "room", "error": "5", "seed": "1", "failure": "exit code 1"}
        self.assertIn("| 5 px | 1 | - / - | - / - | - |", ladder.markdown([[run("0", f=0.8)], [failed, failed]]))
        with tempfile.TemporaryDirectory() as folder:
            ladder.write_tables(Path(folder), "a", [[failed]])
            self.assertIn("room,5,1,", (Path(folder) / "ladder.csv").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
