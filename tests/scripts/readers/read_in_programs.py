# SPDX-License-Identifier: BSD-3-Clause
"""Prints what other programs read of a file, as JSON: read_in_programs.py PROGRAM FILE

    freecad       .step  lengths in millimeters, as everything there
    open3d        .ply   a line set
    meshlab       .obj, .ply: its own .obj of the file is read
    cloudcompare  .dxf   polylines: the clouds of vertices that it writes are read
    librecad      .dxf   flat: what it prints, fitted to a page; with poppler's pdftoppm

`{"missing": PROGRAM}` if that, or one that it needs here, is not installed.
"""

import importlib.util
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

FREECAD_MODULES = ["/usr/lib/freecad/lib", "/usr/lib/freecad/Mod"]  # Debian's
SECONDS = 120
WHITE = 255


class Missing(Exception):
    """A program that is not installed."""


def require(*programs):
    for program in programs:
        if not shutil.which(program):
            raise Missing(program)


def of_chains(chains):
    """Figures of polylines."""
    points = [point for chain in chains for point in chain]
    return {"segments": sum(len(chain) - 1 for chain in chains),
            "length": sum(math.dist(a, b) for chain in chains for a, b in zip(chain, chain[1:])),
            "low": [min(axis) for axis in zip(*points)], "high": [max(axis) for axis in zip(*points)]}


def run(command, folder, **environment):
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, "XDG_RUNTIME_DIR": folder, "HOME": folder, **environment},
                          start_new_session=True) as process:
        try:
            output, _ = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # xvfb-run leaves what it has started
            raise
    if process.returncode != 0:
        raise SystemExit(f"{command}: exit code {process.returncode}\n{output}")


def in_freecad(path, _folder):
    require("freecad")
    sys.path[:0] = FREECAD_MODULES
    import FreeCAD  # noqa: F401, before Part
    import Part
    shape = Part.read(str(path))
    return {"edges": len(shape.Edges), "faces": len(shape.Faces), "valid": shape.isValid(),
            "length": sum(edge.Length for edge in shape.Edges)}


def in_open3d(path, _folder):
    if not importlib.util.find_spec("open3d"):
        raise Missing("open3d")
    import open3d
    lines = open3d.io.read_line_set(str(path))
    points = [tuple(point) for point in lines.points]
    return of_chains([(points[a], points[b]) for a, b in lines.lines])


def in_meshlab(path, folder):
    require("meshlabserver", "xvfb-run")
    read = Path(folder, "read.obj")
    run(["xvfb-run", "-a", "meshlabserver", "-i", path, "-o", read], folder)
    lines = [line.split() for line in read.read_text(encoding="ascii").splitlines()]
    points = [tuple(map(float, words[1:4])) for words in lines if words[:1] == ["v"]]
    return of_chains([[points[int(word) - 1] for word in words[1:]] for words in lines if words[:1] == ["l"]])


def in_cloudcompare(path, folder):
    require("CloudCompare")
    copy = shutil.copy(path, folder)
    run(["CloudCompare", "-SILENT", "-O", copy, "-C_EXPORT_FMT", "ASC", "-SAVE_CLOUDS"], folder,
        QT_QPA_PLATFORM="offscreen")
    clouds = [cloud.read_text(encoding="ascii").splitlines() for cloud in sorted(Path(folder).glob("*.asc"))]
    return of_chains([[tuple(map(float, line.split()[:3])) for line in cloud] for cloud in clouds])


def in_librecad(path, folder):
    require("librecad", "pdftoppm")
    copy = Path(shutil.copy(path, folder))
    run(["librecad", "dxf2pdf", "--fit", "--paper", "297x210", copy], folder, QT_QPA_PLATFORM="offscreen")
    run(["pdftoppm", "-gray", "-singlefile", "-scale-to", "2000", copy.with_suffix(".pdf"), "page"], folder)
    picture = Path(folder, "page.pgm").read_bytes()
    width, height = map(int, re.match(rb"P5\s(\d+) (\d+)\s255\s", picture).groups())
    pixels = picture[-width * height:]
    rows = [pixels[y * width:(y + 1) * width] for y in range(height)]
    inked = [y for y, row in enumerate(rows) if min(row) < WHITE]
    left = min(next(x for x in range(width) if rows[y][x] < WHITE) for y in inked)
    right = max(next(x for x in reversed(range(width)) if rows[y][x] < WHITE) for y in inked)
    return {"width_by_height": (right - left) / (inked[-1] - inked[0])}


READERS = {"freecad": in_freecad, "open3d": in_open3d, "meshlab": in_meshlab, "cloudcompare": in_cloudcompare,
           "librecad": in_librecad}

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        try:
            found = READERS[sys.argv[1]](Path(sys.argv[2]).resolve(), temporary)
        except Missing as missing:
            found = {"missing": str(missing)}
    print("\n" + json.dumps(found))
