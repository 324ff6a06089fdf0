#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far the lines of drawings are from the directions of true edges:

    scripts/bench/direction_errors.py --truth truth.ply --distance 0.01 drawing.json regular.json ...

A line of a drawing (a link whose primitive is a line, neither tentative nor an outline) is compared with the nearest
segment of the truth within `distance` (world units) of its middle that is within 5 degrees of it. Printed per drawing:
lines compared, and, weighted by length, median and 90 % quantile of the angle (degrees) and of the distance of its
middle from the line of the segment. The truth is a PLY of vertices (double, if binary) and edges.
"""

import argparse
import json

import numpy as np

MAX_ANGLE_DEG = 5


def read_segments(path):
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts = {words[1]: int(words[2]) for words in
              (line.split() for line in data[:end].decode().splitlines()) if words[0] == "element"}
    if b"format ascii" in data[:end]:
        numbers = data[end:].split()
        points = np.array(numbers[:3 * counts["vertex"]], float).reshape(-1, 3)
        edges = np.array(numbers[3 * counts["vertex"]:][:2 * counts["edge"]], int).reshape(-1, 2)
        return points[edges[:, 0]], points[edges[:, 1]]
    points = np.frombuffer(data, "<f8", 3 * counts["vertex"], end).reshape(-1, 3)
    edges = np.frombuffer(data, "<i4", 2 * counts["edge"], end + points.nbytes).reshape(-1, 2)
    return points[edges[:, 0]], points[edges[:, 1]]


def read_lines(path):
    with open(path, encoding="utf-8") as file:
        links = json.load(file)["links"]
    lines = [(link["primitive"]["start"], link["primitive"]["end"]) for link in links
             if link.get("primitive", {}).get("type") == "line" and not link.get("tentative")
             and link["kind"] != "contour"]
    return np.array(lines).reshape(-1, 2, 3)


def errors(lines, starts, ends, distance):
    """Length, angle in degrees and offset of each line that has a true segment."""
    chords = ends - starts
    lengths = np.linalg.norm(chords, axis=1)
    directions = chords / np.maximum(lengths, 1e-300)[:, None]
    found = []
    for a, b in lines:
        middle, length = (a + b) / 2, np.linalg.norm(b - a)
        cosines = np.abs(directions @ ((b - a) / length))
        along = np.clip(np.einsum("ij,ij->i", middle - starts, directions), 0, lengths)
        gaps = np.linalg.norm(middle - starts - along[:, None] * directions, axis=1)
        gaps[(cosines < np.cos(np.radians(MAX_ANGLE_DEG))) | (lengths == 0)] = np.inf
        best = int(np.argmin(gaps))
        if gaps[best] <= distance:
            sine = np.linalg.norm(np.cross(directions[best], (b - a) / length))
            across = middle - starts[best]
            offset = np.linalg.norm(across - across @ directions[best] * directions[best])
            found.append((length, np.degrees(np.arcsin(min(1, sine))), offset))
    return np.array(found).reshape(-1, 3)


def quantile(values, weights, share):
    order = np.argsort(values)
    at = np.searchsorted(np.cumsum(weights[order]), share * weights.sum())
    return values[order[min(at, len(values) - 1)]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--truth", required=True)
    parser.add_argument("--distance", type=float, required=True)
    parser.add_argument("drawings", nargs="+")
    options = parser.parse_args()
    starts, ends = read_segments(options.truth)
    print("lines  angle: median, 90 %  offset: median, 90 %  drawing")
    for path in options.drawings:
        found = errors(read_lines(path), starts, ends, options.distance)
        if len(found) == 0:
            print(f"{0:5}  {path}")
            continue
        length, angle, offset = found.T
        print(f"{len(found):5}  {quantile(angle, length, .5):.4f} {quantile(angle, length, .9):.4f}  "
              f"{quantile(offset, length, .5):.3g} {quantile(offset, length, .9):.3g}  {path}")


if __name__ == "__main__":
    main()
