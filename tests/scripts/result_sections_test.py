# SPDX-License-Identifier: BSD-3-Clause
"""Tests of sections of datasets/RESULTS.md: what their tables show."""

import sys
import unittest
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/bench"))
sys.dont_write_bytecode = True

import confidence_section  # noqa: E402
import costs_section  # noqa: E402


@dataclass
class Scene:
    name: str
    is_right: bool = False
    base: str = ""


def stage(name, *runs):
    return {"stage": name, "seconds": [run / 2 for run in runs], "cpu_seconds": list(runs), "peak_mb": [10 * run for run in runs]}


class FalseConfidence(unittest.TestCase):
    def table(self, outcomes):
        text = confidence_section.section("limn 1", 320, outcomes)
        self.assertIn("with limn 1:", text)
        return text

    def test_counts_by_cameras_and_pictures(self):
        text = self.table([(Scene("day", is_right=True), "not warned"), (Scene("day-nine", is_right=True), "warned"),
                           (Scene("day-turned", base="day"), "mended"), (Scene("day-scaled", base="day"), "not warned"),
                           (Scene("day-far", base="day"), "failed"), (Scene("art-1-mirrored"), "warned")])
        self.assertIn("| right | sets | 2 | 1 |  | 0 | 1 |\n", text)
        self.assertIn("| parts moved | sets | 3 | 0 | 1 | 1 | 1 |\n", text)
        self.assertIn("| exchanged | flat and repetitive pictures | 1 | 1 |  | 0 | 0 |\n", text)
        self.assertTrue(text.endswith("missed: day-nine, day-scaled, day-far.\n"), text[-60:])

    def test_says_that_nothing_failed(self):
        self.assertTrue(self.table([(Scene("day", is_right=True), "not warned")]).endswith("missed: none.\n"))


class Costs(unittest.TestCase):
    def test_medians_and_shares_per_set(self):
        sets = [{"name": "a", "num_views": 3, "stages": [stage("first", 1, 4, 1), stage("last", 3, 4, 3), stage("total", 4, 8, 4)]},
                {"name": "b", "num_views": 5, "stages": [stage("first", 9), stage("last", 1), stage("total", 10)]}]
        self.assertEqual(costs_section.table(sets).splitlines(), [
            "|  | a | b |", "| --- | --- | --- |", "| views | 3 | 5 |", "| s | 2 | 5 |", "| CPU s | 4 | 10 |", "| peak MB | 40 | 100 |",
            "| first, % of CPU s | 38 | 90 |", "| last, % of CPU s | 62 | 10 |"])


if __name__ == "__main__":
    unittest.main()
