# SPDX-License-Identifier: BSD-3-Clause
"""Prints what other programs read of a file, as JSON: read_in_programs.py PROGRAM FILE

    freecad       .step  lengths in millimeters, as everything there
    open3d        .ply   a line set
    meshlab       .obj, .ply: its own .obj of the file is read
    cloudcompare  .dxf   polylines: the clouds of vertices that it writes are read
    librecad      .dxf   flat: what it prints, fitted to a page; with poppler's pdftoppm

`{"missing": true}` if the program is not installed.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FREECAD = ["/usr/lib/freecad/lib", "/usr/lib/freecad/Mod"]
SECONDS = 120
WHITE = 255


def of_chains(chains):
    """Figures of polylines."""
    points = [point for chain in chains for point in chain]
    return {"chains": len(chains), "segments": sum(len(chain) - 1 for chain in chains),
            "length": sum(math.dist(a, b) for chain in chains for a, b in zip(chain, chain[1:])),
            "low": [min(axis) for axis in zip(*points)], "high": [max(axis) for axis in zip(*points)]}


def run(command, folder, **environment):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False,
                          env={**os.environ, "XDG_RUNTIME_DIR": folder, "HOME": folder, **environment})
    if done.returncode != 0:
        raise SystemExit(f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")


def in_freecad(path, _folder):
    sys.path[:0] = FREECAD
    try:
        import FreeCAD  # noqa: F401, before Part
        import Part
    except ImportError:
        return None
    shape = Part.read(str(path))
    box = shape.BoundBox
    return {"edges": len(shape.Edges), "faces": len(shape.Faces), "solids": len(shape.Solids), "valid": shape.isValid(),
            "length": sum(edge.Length for edge in shape.Edges),
            "low": [box.XMin, box.YMin, box.ZMin], "high": [box.XMax, box.YMax, box.ZMax]}


def in_open3d(path, _folder):
    try:
        import open3d
    except ImportError:
        return None
    lines = open3d.io.read_line_set(str(path))
    points = [tuple(point) for point in lines.points]
    return of_chains([(points[a], points[b]) for a, b in lines.lines])


def in_meshlab(path, folder):
    if not shutil.which("meshlabserver") or not shutil.which("xvfb-run"):
        return None
    read = Path(folder, "read.obj")
    run(["xvfb-run", "-a", "meshlabserver", "-i", path, "-o", read], folder)
    lines = [line.split() for line in read.read_text(encoding="ascii").splitlines()]
    points = [tuple(map(float, words[1:4])) for words in lines if words[:1] == ["v"]]
    return of_chains([[points[int(word) - 1] for word in words[1:]] for words in lines if words[:1] == ["l"]])


def in_cloudcompare(path, folder):
    if not shutil.which("CloudCompare"):
        return None
    copy = shutil.copy(path, folder)
    run(["CloudCompare", "-SILENT", "-O", copy, "-C_EXPORT_FMT", "ASC", "-SAVE_CLOUDS"], folder, QT_QPA_PLATFORM="offscreen")
    clouds = [cloud.read_text(encoding="ascii").splitlines() for cloud in sorted(Path(folder).glob("*.asc"))]
    return of_chains([[tuple(map(float, line.split()[:3])) for line in cloud] for cloud in clouds])


def in_librecad(path, folder):
    if not shutil.which("librecad") or not shutil.which("pdftoppm"):
        return None
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


READERS = {name[len("in_"):]: value for name, value in list(globals().items()) if name.startswith("in_")}

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        found = READERS[sys.argv[1]](Path(sys.argv[2]).resolve(), temporary)
    print("\n" + json.dumps(found or {"missing": True}))
