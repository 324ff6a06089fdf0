#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How time and memory grow with the number of views, from reports of large_scene, as a section of datasets/RESULTS.md.

    street_section.py FOLDER PICTURE

FOLDER has <number of views>/report.json. Prints the section, and draws PICTURE.
"""

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HEAD = """## Many views

Written by `scripts/measure_street.sh`: the stages after the image curves on a street whose image curves are generated, some 20,000 edgels per view as in
a photograph of 2 MP, every view overlapping with about 30 others; in tiles of at most 150 views. *Exponent*: of the line of log(CPU time) over log(views)
through all rows.

![Time and memory over views](results/{picture})

"""


def read(folder):
    """(views, wall s, CPU s, MB) by views, ascending."""
    rows = []
    for path in Path(folder).glob("*/report.json"):
        stages = {stage["stage"]: stage for stage in json.loads(path.read_text(encoding="utf-8"))["sets"][0]["stages"]}
        total = stages["total"]
        rows.append((int(path.parent.name), total["seconds"][0], total["cpu_seconds"][0], total["peak_mb"][0]))
    return sorted(rows)


def draw(rows, picture):
    views, wall, cpu, memory = (np.array(column) for column in zip(*rows))
    figure, (times, sizes) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    times.loglog(views, cpu, "o-", label="CPU time")
    times.loglog(views, wall, "s-", label="wall time")
    times.loglog(views, cpu[0] * views / views[0], "k:", label="linear")
    times.set(xlabel="views", ylabel="s")
    times.legend()
    sizes.semilogx(views, memory / 1000, "o-")
    sizes.set(xlabel="views", ylabel="peak memory, GB", ylim=(0, None))
    figure.savefig(picture, dpi=90)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: street_section.py FOLDER PICTURE")
    folder, picture = sys.argv[1:]
    rows = read(folder)
    if len(rows) < 2:
        sys.exit(f"ERROR: {folder}: needs reports of at least two numbers of views: <views>/report.json")
    draw(rows, picture)
    exponent = np.polyfit(np.log([row[0] for row in rows]), np.log([row[2] for row in rows]), 1)[0]
    print(HEAD.format(picture=Path(picture).name), end="")
    print("| views | wall s | CPU s | CPU s per view | cores used | peak memory, MB |\n| --- | --- | --- | --- | --- | --- |")
    for views, wall, cpu, memory in rows:
        print(f"| {views} | {wall:.1f} | {cpu:.1f} | {cpu / views:.3f} | {cpu / wall:.2f} | {memory:.0f} |")
    print(f"\nExponent: {exponent:.2f}.")


if __name__ == "__main__":
    main()
