#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times the main job and COLMAP's first steps alternately on the same images.

    compare_colmap.py LIMN WORKSPACE [RUNS]

`colmap feature_extractor` and `colmap exhaustive_matcher` on the CPU into a fresh database, with all cores and
COLMAP's defaults, and `limn automatic_drawer` into a fresh folder. Prints medians and, for several runs, minima and
maxima; the ratio is that of the sums of each run.
"""

import os
import statistics
import sys
import tempfile
from pathlib import Path

from measured_run import Run, main, warm


def run_colmap(images, folder):
    database = Path(folder) / "database.db"
    extractor = Run(["colmap", "feature_extractor", "--database_path", database, "--image_path", images,
                     "--SiftExtraction.use_gpu", 0])
    matcher = Run(["colmap", "exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu", 0])
    return {"colmap feature_extractor": extractor, "colmap exhaustive_matcher": matcher}


def run_limn(limn, workspace, folder):
    return {"limn automatic_drawer": Run([limn, "automatic_drawer", "--workspace_path", workspace,
                                          "--output_path", folder])}


def with_spread(numbers, digits):
    text = f"{statistics.median(numbers):.{digits}f}"
    if len(numbers) == 1:
        return text
    return f"{text} ({min(numbers):.{digits}f} to {max(numbers):.{digits}f})"


def body():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: compare_colmap.py LIMN WORKSPACE [RUNS]")
    limn, workspace = sys.argv[1:3]
    runs = int(sys.argv[3]) if len(sys.argv) == 4 else 1
    images = Path(workspace) / "images"
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    warm(workspace)
    steps, ratios = {}, {"s": [], "CPU s": []}
    for i in range(runs):
        with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
            # Who goes first changes.
            if i % 2 == 0:
                colmap, drawer = run_colmap(images, a), run_limn(limn, workspace, b)
            else:
                drawer, colmap = run_limn(limn, workspace, b), run_colmap(images, a)
        for name, run in {**colmap, **drawer}.items():
            steps.setdefault(name, []).append(run)
        for unit, key in (("s", "seconds"), ("CPU s", "cpu_seconds")):
            theirs, ours = (sum(getattr(run, key) for run in side.values()) for side in (colmap, drawer))
            ratios[unit].append(ours / theirs)
    print(f"{workspace}: {len(list(images.rglob('*.*')))} images, {runs} runs\n")
    print("| step | s | CPU s | peak MB |\n|---|---|---|---|")
    for name, done in steps.items():
        print(f"| {name} | {with_spread([run.seconds for run in done], 1)} "
              f"| {with_spread([run.cpu_seconds for run in done], 1)} "
              f"| {with_spread([run.peak_mb for run in done], 0)} |")
    print(f"| limn over both of COLMAP's | {with_spread(ratios['s'], 2)} | {with_spread(ratios['CPU s'], 2)} | |")


if __name__ == "__main__":
    main(body)
