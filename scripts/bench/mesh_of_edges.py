#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of a solid from its true edges, for drawing_evaluator --truth_mesh_path:

    scripts/bench/mesh_of_edges.py curves.ply mesh.ply

For solids whose sides are flat, with one border each, or ruled between two equal arcs, such as abc-00000952 and abc-00004926.
Flat sides are the shortest loops of edges in each plane; what is left must be loops of four edges, whose two arcs are
joined. Fails unless every edge then has two sides.
"""

import argparse
import sys
from collections import Counter, defaultdict
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "sample_scene"))

from direction_errors import read_segments  # noqa: E402
from mesh import write_mesh  # noqa: E402

FLAT = 1e-4  # of the size of the solid
MAX_EDGES = 8  # of a loop


def edges_between_corners(starts, ends, tolerance):
    """Polylines between points where other than two segments meet."""
    neighbors, places = defaultdict(list), {}
    for a, b in zip(starts, ends):
        keys = [tuple(np.round(p / tolerance).astype(int)) for p in (a, b)]
        places.update(zip(keys, (a, b)))
        neighbors[keys[0]].append(keys[1])
        neighbors[keys[1]].append(keys[0])
    edges = []
    for corner, around in neighbors.items():
        if len(around) == 2:
            continue
        for following in around:
            chain = [corner, following]
            while len(neighbors[chain[-1]]) == 2:
                chain.append(next(n for n in neighbors[chain[-1]] if n != chain[-2]))
            if chain[0] < chain[-1]:
                edges.append((chain[0], chain[-1], np.array([places[key] for key in chain])))
    return edges


def plane_of(points, tolerance):
    """Normal and offset with a positive first number; None if the points are on a line or in no plane."""
    middle = points.mean(0)
    _, sizes, axes = np.linalg.svd(points - middle, full_matrices=False)
    if sizes[1] < tolerance or np.abs((points - middle) @ axes[2]).max() > tolerance:
        return None
    normal = axes[2] * (1 if axes[2][np.argmax(np.abs(axes[2]) > 1e-6)] > 0 else -1)
    return np.append(normal, normal @ middle)


def loops_from(edges, tolerance):
    """Loops in a plane: lists of edge numbers in order; each once, and none that has other corners than it needs."""
    at = defaultdict(list)
    for number, (a, b, _) in enumerate(edges):
        at[a].append(number)
        at[b].append(number)
    found = {}

    def points_of(path):
        return np.concatenate([edges[number][2] for number in path])

    def extend(start, corner, path, visited):
        for number in at[corner]:
            if number in path or number < path[0]:
                continue
            a, b, _ = edges[number]
            following = b if a == corner else a
            longer = path + [number]
            bends = np.linalg.svd(points_of(longer) - points_of(longer).mean(0), compute_uv=False)[2] > tolerance
            if bends:
                continue
            if following == start:
                found.setdefault(frozenset(longer), longer)
            elif following not in visited and len(longer) < MAX_EDGES:
                extend(start, following, longer, visited | {following})

    for number, (a, b, _) in enumerate(edges):
        extend(a, b, [number], {a, b})
    loops = [loop for loop in found.values() if plane_of(points_of(loop), tolerance) is not None]
    return sorted(loops, key=lambda loop: (len(loop), loop))


def polygon(loop, edges):
    """The points around a loop, without those between straight neighbors."""
    corner = edges[loop[0]][0] if edges[loop[0]][0] not in edges[loop[1]][:2] else edges[loop[0]][1]
    points = []
    for number in loop:
        a, b, course = edges[number]
        points.extend((course if a == corner else course[::-1])[:-1])
        corner = b if a == corner else a
    points = np.array(points)
    before, after = points - np.roll(points, 1, 0), np.roll(points, -1, 0) - points
    sine = np.linalg.norm(np.cross(before, after), axis=1) / np.linalg.norm(before, axis=1) / np.linalg.norm(after, axis=1)
    return points[sine > 1e-3]


def is_straight(course, tolerance):
    return np.linalg.svd(course - course.mean(0), compute_uv=False)[1] < tolerance


def ruled(numbers, edges, tolerance):
    """Quadrilaterals between pairs of arcs whose ends straight edges join."""
    arcs = [n for n in numbers if not is_straight(edges[n][2], tolerance)]
    joined = {frozenset(edges[n][:2]) for n in numbers if n not in arcs}
    while arcs:
        a, b, course = edges[arcs.pop(0)]
        for other in arcs:
            c, d, course2 = edges[other]
            if {frozenset((a, d)), frozenset((b, c))} <= joined:
                c, d, course2 = d, c, course2[::-1]
            if {frozenset((a, c)), frozenset((b, d))} <= joined and len(course) == len(course2):
                arcs.remove(other)
                for i in range(len(course) - 1):
                    yield np.array([course[i], course[i + 1], course2[i + 1], course2[i]])
                break
        else:
            sys.exit("an arc has no other arc that it could be joined with")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("curves")
    parser.add_argument("mesh", type=Path)
    options = parser.parse_args()
    starts, ends = read_segments(options.curves)
    tolerance = FLAT * np.ptp(np.vstack([starts, ends]), axis=0).max()
    edges = edges_between_corners(starts, ends, tolerance)
    loops = loops_from(edges, tolerance)
    sides = Counter(number for loop in loops for number in loop)
    left = [n for n in range(len(edges)) if sides[n] < 2]
    arcs = sum(not is_straight(edges[n][2], tolerance) for n in left)
    if max(sides.values()) > 2 or len(left) != 2 * arcs:
        sys.exit(f"{options.curves}: not the edges of such a solid: {len(edges)} edges, {len(loops)} flat loops, {len(left)} edges left")
    polygons = [polygon(loop, edges) for loop in loops] + list(ruled(left, edges, tolerance))
    index, faces = {}, []
    for points in polygons:
        faces.append([index.setdefault(tuple(np.round(p, 9)), len(index)) for p in points])
    write_mesh(options.mesh, list(index), faces, f"surfaces between the edges of {Path(options.curves).name}")
    print(f"{options.mesh}: {len(loops)} flat sides, {arcs // 2} ruled sides")


if __name__ == "__main__":
    main()
