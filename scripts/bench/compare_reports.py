#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares reports of stages (tests/bench/stage_costs.h) of two commits, as a Markdown table.

    compare_reports.py FOLDER     with a-1.json, b-1.json, a-2.json, b-2.json, ...: run i of A is paired with run i of B

Ratios are the median of B over the median of A and, in brackets, the smallest and the largest ratio of a pair of
runs. Differences of precision, recall and F are in percentage points, B minus A, at each tau in the first box.
"""

import json
import statistics
import sys
from pathlib import Path


def read_reports(folder, letter):
    paths = sorted(folder.glob(f"{letter}-*.json"), key=lambda path: int(path.stem.split("-")[1]))
    return [json.loads(path.read_text(encoding="utf-8")) for path in paths]


def stages_of(reports):
    """{(set, stage): [the stage in each report]}, in the order of the first report."""
    stages = {}
    for report in reports:
        for data_set in report["sets"]:
            for stage in data_set["stages"]:
                stages.setdefault((data_set["name"], stage["stage"]), []).append(stage)
    return stages


def values(stages, key):
    """One number per report: the median of its runs."""
    return [statistics.median(stage[key]) for stage in stages if stage[key]]


def ratio(a, b):
    if not a or not b or min(a) <= 0:
        return "-"
    pairs = [y / x for x, y in zip(a, b)]
    return f"{statistics.median(b) / statistics.median(a):.3f} ({min(pairs):.3f} to {max(pairs):.3f})"


def both(a, b, digits):
    if not a or not b:
        return "-"
    return f"{statistics.median(a):.{digits}f}, {statistics.median(b):.{digits}f}"


def differences(a, b):
    """P / R / F, tau by tau; empty where there is no truth."""
    if a["truth"] is None or b["truth"] is None:
        return ""
    box = next(iter(a["truth"]))
    cells = []
    for row_a, row_b in zip(a["truth"][box], b["truth"][box]):
        shares = [(row_a[key], row_b[key]) for key in ("precision", "recall", "f")]
        cells.append(" / ".join("-" if None in pair else f"{100 * (pair[1] - pair[0]):+.1f}" for pair in shares))
    return "; ".join(cells)


def print_row(cells):
    print("| " + " | ".join(cells) + " |")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: compare_reports.py FOLDER")
    reports_a, reports_b = (read_reports(Path(sys.argv[1]), letter) for letter in "ab")
    if not reports_a or len(reports_a) != len(reports_b):
        sys.exit(f"ERROR: {sys.argv[1]}: needs as many reports a-*.json as b-*.json, at least one")
    if len({report["format"] for report in reports_a + reports_b}) > 1:
        sys.exit(f"ERROR: {sys.argv[1]}: A and B do not measure the same: their reports have different formats")
    stages_a, stages_b = stages_of(reports_a), stages_of(reports_b)
    print(f"A = {reports_a[0]['commit']}, B = {reports_b[0]['commit']}, {len(reports_a)} runs each\n")
    print_row(["set", "stage", "s: A, B", "B / A", "CPU s: A, B", "B / A", "peak MB: A, B", "B / A",
               "P / R / F, B - A, per tau"])
    print_row(["---"] * 9)
    for key, a in stages_a.items():
        b = stages_b.get(key)
        if b is None:
            print_row([*key, "only in A"] + [""] * 6)
            continue
        cells = list(key)
        for figure, digits in (("seconds", 2), ("cpu_seconds", 2), ("peak_mb", 0)):
            pair = values(a, figure), values(b, figure)
            cells += [both(*pair, digits), ratio(*pair)]
        print_row(cells + [differences(a[0], b[0])])
    for key in stages_b:
        if key not in stages_a:
            print_row([*key, "only in B"] + [""] * 6)


main()
