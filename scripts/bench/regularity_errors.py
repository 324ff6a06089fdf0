#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far the planes and circles of a drawing are from true ones, before and after drawing_regularizer:

    scripts/bench/regularity_errors.py --truth truth.ply --distance 0.01 --footprint 0.005 drawing.json regular.json
        [--min_sweep 1] [--unopposed all.json]

regular.json is drawing.json after drawing_regularizer: the same links in the same order.

Planes: those of regular.json. The true plane is that of the true segments along the links that follow it (within
`distance`, world units, and 5 degrees): of the links that lie in one true plane, those with the greatest length;
the others are counted as foreign. Before: the plane through the shapes of the same links in drawing.json.
Printed: angle of the normals (degrees) and distance of the planes in the middle of the links (footprints), medians and
maxima over planes, and how many are no true planes (less than half of the matched length lies in one).

Circles: arcs and circles that turn by `min_sweep` radians or more and run along a true circle (fitted to the vertices of true
segments along them). Printed: relative errors of radii, angles of axes (degrees), distances of centers (footprints).

--unopposed: drawing.json after drawing_regularizer with --Regularity.max_growth_px 10, which lets no link go.
Printed: whether links that follow directions or planes there but none in regular.json do so in truth (or some of them
only), within 0.1 degrees and 0.1 footprints of the true curves of those that follow them in both.
"""

import argparse
import json

import numpy as np

from direction_errors import MAX_ANGLE_DEG, read_segments

SAMPLES = 16
SAME_DEG = 0.1
SAME_PX = 0.1


def unit(v):
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-300)


def samples(primitive):
    """Points along a primitive and its unit tangents there; None for splines."""
    t = (np.arange(SAMPLES) + 0.5)[:, None] / SAMPLES
    if primitive["type"] == "line":
        a, b = np.array(primitive["start"]), np.array(primitive["end"])
        return a + t * (b - a), np.repeat(unit(b - a)[None], SAMPLES, 0)
    if primitive["type"] not in ("arc", "circle"):
        return None
    center, x, y = (np.array(primitive[key]) for key in ("center", "x_axis", "y_axis"))
    angle = t * primitive["sweep_rad"]
    return (center + primitive["radius"] * (np.cos(angle) * x + np.sin(angle) * y),
            unit(np.cos(angle) * y - np.sin(angle) * x))


class Truth:
    def __init__(self, path, distance):
        self.starts, self.ends = read_segments(path)
        self.chords = self.ends - self.starts
        self.lengths = np.linalg.norm(self.chords, axis=1)
        self.directions = unit(self.chords)
        self.distance = distance

    def along(self, points, tangents):
        """Per point the nearest true segment that runs along it, -1 if there is none, and its nearest point."""
        segments, feet = np.full(len(points), -1), np.zeros_like(points)
        for i, (point, tangent) in enumerate(zip(points, tangents)):
            at = np.clip(np.einsum("ij,ij->i", point - self.starts, self.directions), 0, self.lengths)
            near = self.starts + at[:, None] * self.directions
            gaps = np.linalg.norm(point - near, axis=1)
            gaps[np.abs(self.directions @ tangent) < np.cos(np.radians(MAX_ANGLE_DEG))] = np.inf
            best = int(np.argmin(gaps))
            if gaps[best] <= self.distance:
                segments[i], feet[i] = best, near[best]
        return segments, feet


def plane_through(points):
    """Normal and offset; None if the points are on a line."""
    middle = points.mean(0)
    _, sizes, axes = np.linalg.svd(points - middle)
    if len(points) < 3 or sizes[1] < 1e-3 * sizes[0]:
        return None
    return axes[2], axes[2] @ middle


def true_plane(places, tolerance):
    """The plane of most of the places (a list of arrays, one per link), and which links lie in it.

    Links are left out one by one, the farthest first, until all are within the tolerance."""
    inside = list(range(len(places)))
    while inside:
        plane = plane_through(np.concatenate([places[i] for i in inside]))
        if plane is None:
            return None, []
        gaps = [np.abs(places[i] @ plane[0] - plane[1]).max() for i in inside]
        if max(gaps) <= tolerance:
            return plane, inside
        del inside[int(np.argmax(gaps))]
    return None, []


def angle_deg(a, b):
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), abs(a @ b)))


def spread(values, digits=3):
    if not values:
        return "-"
    return f"{np.median(values):.{digits}f} (at most {np.max(values):.{digits}f})"


def planes(before, after, truth, footprint):
    errors = {"before": [], "after": []}
    num_false = num_unknown = num_foreign = num_unmatched = 0
    for p, plane in enumerate(after["regularities"]["planes"]):
        links = [i for i, link in enumerate(after["links"]) if p in link.get("regularity", {}).get("planes", [])]
        places, matched = [], []
        for i in links:
            segments, feet = truth.along(*samples(before["links"][i]["primitive"]))
            if (segments >= 0).sum() >= SAMPLES / 2:
                places.append(feet[segments >= 0])
                matched.append(i)
        num_unmatched += len(links) - len(matched)
        if not places or plane_through(np.concatenate(places)) is None:
            num_unknown += 1
            continue
        true, inside = true_plane(places, SAME_PX * footprint)
        lengths = np.array([after["links"][i]["length"] for i in matched])
        if true is None or lengths[inside].sum() < lengths.sum() / 2:
            num_false += 1
            continue
        num_foreign += len(matched) - len(inside)
        old = plane_through(np.concatenate([samples(before["links"][i]["primitive"])[0] for i in links]))
        middle = np.concatenate([samples(after["links"][i]["primitive"])[0] for i in links]).mean(0)
        for name, (normal, offset) in (("before", old), ("after", (np.array(plane["normal"]), plane["offset"]))):
            away = (middle @ true[0] - true[1]) - np.sign(true[0] @ normal) * (middle @ normal - offset)
            errors[name].append((angle_deg(normal, true[0]), abs(away) / footprint))
    count = len(after["regularities"]["planes"])
    print(f"planes: {count}, of these {num_false} are none in truth and {num_unknown} unknown, since "
          f"their links have no true curves; links off the true plane: {num_foreign}, without a true curve: {num_unmatched}")
    for name, found in errors.items():
        print(f"  {name:6}  normal {spread([e[0] for e in found])} deg, distance {spread([e[1] for e in found])} px")


def circle_through(points):
    """Center, radius and axis; None if the points are on no circle."""
    plane = plane_through(points) if len(points) >= 5 else None
    if plane is None:
        return None
    normal = plane[0]
    x = unit(np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))]))
    y = np.cross(normal, x)
    middle = points.mean(0)
    flat = np.stack([(points - middle) @ x, (points - middle) @ y], 1)
    solution = np.linalg.lstsq(np.c_[2 * flat, np.ones(len(flat))], (flat ** 2).sum(1), rcond=None)[0]
    radius = np.sqrt(solution[2] + solution[:2] @ solution[:2])
    center = middle + solution[0] * x + solution[1] * y
    off = np.abs(np.linalg.norm(points - center, axis=1) - radius).max() + np.abs((points - middle) @ normal).max()
    return (center, radius, normal) if off < 1e-3 * radius else None


def circles(before, after, truth, footprint, min_sweep):
    errors = {"before": [], "after": []}
    num_arcs = num_regular = 0
    for old, new in zip(before["links"], after["links"]):
        if old.get("tentative") or any(link["primitive"]["type"] not in ("arc", "circle") or
                                       link["primitive"]["sweep_rad"] < min_sweep for link in (old, new)):
            continue
        num_arcs += 1
        segments, _ = truth.along(*samples(old["primitive"]))
        used = np.unique(segments[segments >= 0])
        if (segments >= 0).sum() < SAMPLES / 2:
            continue
        true = circle_through(np.unique(np.concatenate([truth.starts[used], truth.ends[used]]), axis=0))
        if true is None:
            continue
        num_regular += "regularity" in new
        for name, link in (("before", old), ("after", new)):
            arc = link["primitive"]
            errors[name].append((abs(arc["radius"] / true[1] - 1), angle_deg(np.cross(arc["x_axis"], arc["y_axis"]), true[2]),
                                 np.linalg.norm(np.array(arc["center"]) - true[0]) / footprint, "regularity" in new))
    print(f"circles: {num_arcs} arcs of {min_sweep:g} radians or more, {len(errors['after'])} along true circles, {num_regular} of these regular")
    for which, chosen in (("all", lambda e: True), ("regular", lambda e: e[3])):
        for name, found in errors.items():
            found = [e for e in found if chosen(e)]
            print(f"  {which:7} {name:6}  radius {spread([100 * e[0] for e in found])} %, axis {spread([e[1] for e in found])} deg, "
                  f"center {spread([e[2] for e in found])} px")


def let_go(before, after, unopposed, truth, footprint):
    """Whether what the images opposed is so in truth."""
    count = {"so in truth": 0, "so in part": 0, "not so": 0, "without a true curve": 0}
    longest = []
    found = unopposed["regularities"]
    matches = {}

    def match(i):
        if i not in matches:
            matches[i] = truth.along(*samples(before["links"][i]["primitive"]))
        return matches[i]

    def directions_of(i):
        segments, _ = match(i)
        return truth.directions[segments[segments >= 0]]

    # The links that follow the same in the unopposed drawing, and something in the other.
    kept = {}
    for i, (link, all_link) in enumerate(zip(after["links"], unopposed["links"])):
        if "regularity" not in link or "regularity" not in all_link:
            continue
        kept.setdefault(("direction", all_link["regularity"].get("direction", -1)), []).append(i)
        for p in all_link["regularity"].get("planes", []):
            kept.setdefault(("plane", p), []).append(i)
    for i, (link, all_link) in enumerate(zip(after["links"], unopposed["links"])):
        if "regularity" in link or "regularity" not in all_link:
            continue
        segments, feet = match(i)
        if (segments >= 0).sum() < SAMPLES / 2:
            count["without a true curve"] += 1
            continue
        follows = []
        regularity = all_link["regularity"]
        if regularity.get("direction", -1) >= 0:
            members = [k for k in kept.get(("direction", regularity["direction"]), []) if len(directions_of(k))]
            common = np.concatenate([directions_of(k) for k in members]) if members else None
            if common is None:
                common = np.array([found["directions"][regularity["direction"]]["direction"]])
            common = common * np.sign(common @ common[0])[:, None]
            true = unit(np.median(common, axis=0))
            follows.append(min(angle_deg(d, true) for d in directions_of(i)) <= SAME_DEG)
        for p in regularity.get("planes", []):
            members = [k for k in kept.get(("plane", p), []) if (match(k)[0] >= 0).any()]
            plane, _ = true_plane([match(k)[1][match(k)[0] >= 0] for k in members], SAME_PX * footprint) if members else (None, [])
            if plane is None:
                plane = np.array(found["planes"][p]["normal"]), found["planes"][p]["offset"]
            gap = np.abs(feet[segments >= 0] @ plane[0] - plane[1]).max() / footprint
            follows.append(gap <= SAME_PX)
        so = "so in truth" if all(follows) else "so in part" if any(follows) else "not so"
        count[so] += 1
        if all(follows):
            longest.append((all_link["length"], i))
    print("let go: " + ", ".join(f"{number} {text}" for text, number in count.items()))
    print("  longest of those that are so in truth:",
          ", ".join(f"link {i} ({length:.3f})" for length, i in sorted(longest)[:-6:-1]))


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--truth", required=True)
    parser.add_argument("--distance", type=float, required=True)
    parser.add_argument("--footprint", type=float, required=True)
    parser.add_argument("--min_sweep", type=float, default=1)
    parser.add_argument("--unopposed")
    parser.add_argument("drawing")
    parser.add_argument("regular")
    options = parser.parse_args()
    truth = Truth(options.truth, options.distance)
    before, after = read(options.drawing), read(options.regular)
    if len(before["links"]) != len(after["links"]):
        parser.error(f"{options.drawing} and {options.regular} have different links")
    planes(before, after, truth, options.footprint)
    circles(before, after, truth, options.footprint, options.min_sweep)
    if options.unopposed:
        let_go(before, after, read(options.unopposed), truth, options.footprint)


if __name__ == "__main__":
    main()
