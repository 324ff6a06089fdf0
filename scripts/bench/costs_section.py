#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a drawing costs, from a report of stage_report, as a section of datasets/RESULTS.md.

    costs_section.py REPORT.json COLMAP.md

COLMAP.md is what compare_colmap.py printed. Prints the section.
"""

import json
import statistics
import sys
from pathlib import Path

HEAD = """## What a drawing costs

Written by `scripts/measure_costs.sh` at commit {commit}: the stages of `limn automatic_drawer` with default options, but with cameras as they are
given, without reading the model and without writing results ([stage_report](../tests/README.md#time-and-memory)); medians.

"""
COLMAP = """
The main job with all that it writes, and COLMAP's first steps on the CPU on the same images (`scripts/compare_colmap.sh`):

"""


def row(cells):
    return f"| {' | '.join(cells)} |\n"


def table(sets):
    """Costs of whole runs, then the share of every stage in the processor time; a column per set."""
    totals = [data_set["stages"][-1] for data_set in sets]
    text = row(["", *(data_set["name"] for data_set in sets)]) + row(["---"] * (len(sets) + 1))
    text += row(["views", *(str(data_set["num_views"]) for data_set in sets)])
    for name, key in (("s", "seconds"), ("CPU s", "cpu_seconds"), ("peak MB", "peak_mb")):
        text += row([name, *(f"{statistics.median(total[key]):.0f}" for total in totals)])
    for i, stage in enumerate(sets[0]["stages"][:-1]):
        shares = (sum(data_set["stages"][i]["cpu_seconds"]) / sum(total["cpu_seconds"]) for data_set, total in zip(sets, totals))
        text += row([f"{stage['stage']}, % of CPU s", *(f"{100 * share:.0f}" for share in shares)])
    return text


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: costs_section.py REPORT.json COLMAP.md")
    report = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    colmap = Path(sys.argv[2]).read_text(encoding="utf-8")
    print(HEAD.format(commit=report["commit"]) + table(report["sets"]) + COLMAP + colmap.strip())


if __name__ == "__main__":
    main()
