#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how time and memory of the main job grow with the number of views of a scene.

    measure_scaling.py LIMN WORKSPACE [RUNS]

The workspace has image lists views-<number>.txt (scripts/sample_scene/build_long.sh). Prints medians per number of
views, stage by stage, and the exponents of the least-squares lines of log(value) over log(views).
"""

import math
import re
import statistics
import sys
import tempfile
from pathlib import Path

from command_report import stages_of
from measured_run import Run, main, warm


def lists_of(workspace):
    """{number of views: image list}, ascending."""
    lists = {int(re.search(r"views-(\d+)", path.name)[1]): path for path in Path(workspace).glob("views-*.txt")}
    return dict(sorted(lists.items()))


def measure(limn, workspace, image_list):
    """{stage: {figure: value}}"""
    with tempfile.TemporaryDirectory() as folder:
        run = Run([limn, "automatic_drawer", "--workspace_path", workspace, "--output_path", folder,
                   "--image_list_path", image_list])
    return {stage["stage"]: {key: stage[key][0] for key in ("seconds", "cpu_seconds", "peak_mb") if stage[key]}
            for stage in stages_of(run)}


def exponent(counts, figures):
    x, y = [math.log(count) for count in counts], [math.log(max(figure, 0.05)) for figure in figures]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x))


def body():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: measure_scaling.py LIMN WORKSPACE [RUNS]")
    limn, workspace = sys.argv[1:3]
    lists = lists_of(workspace)
    if len(lists) < 2:
        sys.exit(f"ERROR: {workspace}: needs two image lists views-<number>.txt or more")
    warm(workspace)
    runs = {count: [] for count in lists}
    for _ in range(int(sys.argv[3]) if len(sys.argv) == 4 else 1):
        for count, image_list in lists.items():
            runs[count].append(measure(limn, workspace, image_list))
    counts = list(runs)
    print("| stage | figure | " + " | ".join(f"{count} views" for count in counts) + " | exponent |")
    print("|---" * (len(counts) + 3) + "|")
    for stage, figures in runs[counts[0]][0].items():
        for figure in figures:
            medians = [statistics.median(run[stage][figure] for run in runs[count]) for count in counts]
            print(f"| {stage} | {figure} | " + " | ".join(f"{median:.1f}" for median in medians)
                  + f" | {exponent(counts, medians):.2f} |")


if __name__ == "__main__":
    main(body)
