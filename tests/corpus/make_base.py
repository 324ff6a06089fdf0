#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Make base/sparse, the small valid model that every case of the corpus corrupts.

  colmap model_converter --input_path datasets/sample/day/sparse --output_path /tmp/txt --output_type TXT
  tests/corpus/make_base.py /tmp/txt

Six images of the sample scene and 60 of its points, in text. The test links the photographs.
"""

import sys
from pathlib import Path

NUM_IMAGES = 6
NUM_POINTS = 60
BASE = Path(__file__).parent / "base" / "sparse"


def records(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def main(source):
    lines = records(source / "images.txt")
    images = sorted((header.split() for header in lines[::2]), key=lambda fields: fields[9])
    images = images[:NUM_IMAGES]
    wanted = {fields[0] for fields in images}
    observed = {header.split()[0]: points.split() for header, points in zip(lines[::2], lines[1::2])}

    rows = []
    for line in records(source / "points3D.txt"):
        fields = line.split()
        track = [(i, int(k)) for i, k in zip(fields[8::2], fields[9::2]) if i in wanted]
        if len(track) >= 3:
            rows.append((fields[:8], track))
    rows = rows[:: max(1, len(rows) // NUM_POINTS)][:NUM_POINTS]

    observations = {image_id: [] for image_id in wanted}
    points = ["# POINT3D_ID X Y Z R G B ERROR (IMAGE_ID POINT2D_IDX)*"]
    for point_id, (fields, track) in enumerate(rows, 1):
        elements = []
        for image_id, index in track:
            x, y = observed[image_id][3 * index: 3 * index + 2]
            elements.append(f"{image_id} {len(observations[image_id])}")
            observations[image_id].append(f"{float(x):.3f} {float(y):.3f} {point_id}")
        xyz = " ".join(f"{float(value):.6f}" for value in fields[1:4])
        points.append(f"{point_id} {xyz} {' '.join(fields[4:7])} 0.5 {' '.join(elements)}")
    headers = ["# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then X Y POINT3D_ID"]
    for fields in images:
        headers += [" ".join(fields), " ".join(observations[fields[0]])]
    BASE.mkdir(parents=True, exist_ok=True)
    (BASE / "images.txt").write_text("\n".join(headers) + "\n")
    (BASE / "points3D.txt").write_text("\n".join(points) + "\n")
    (BASE / "cameras.txt").write_text((source / "cameras.txt").read_text())


if __name__ == "__main__":
    main(Path(sys.argv[1]))
