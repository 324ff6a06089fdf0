# SPDX-License-Identifier: BSD-3-Clause
"""Writes the truth and the depth maps of the sample scene. Runs inside Blender, for its ray casting:

  blender --background --python truth.py -- --sample datasets/sample --sets day,evening,lamp,mixed [--depth]
"""

import argparse
import json
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import cameras  # noqa: E402
import scene  # noqa: E402
import visibility  # noqa: E402
from colmap_files import write_curves, write_depth_map  # noqa: E402
from dont_care import contour_curves, shadow_curves  # noqa: E402
from geometry import Curve  # noqa: E402
from junctions import find_junctions  # noqa: E402
from raycast import RayCaster  # noqa: E402
from truth_curves import index_runs, scene_curves, simplified  # noqa: E402

DEPTH_SCALE = 0.25
# The folder of each set's truth, relative to truth/. The distorted set has the day's light and poses.
FOLDERS = {"day": ".", "evening": "evening", "lamp": "lamp", "mixed": "mixed"}
LIGHTS_OF_SET = {"day": ["day"], "evening": ["evening"], "lamp": ["lamp"], "mixed": list(scene.LIGHTS)}


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=Path, required=True)
    parser.add_argument("--sets", default=",".join(FOLDERS))
    parser.add_argument("--depth", action="store_true", help="write the depth maps too")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def write(path, curves, what):
    write_curves(path, [simplified(c.points) for c in curves], [f"Limn sample scene: {what}"])
    print(f"{path}: {len(curves)} curves, {total_length(curves):.2f} m")


def write_kinds(path, curves):
    """The curves with their kinds, to 0.1 mm."""
    entries = [{"kind": c.kind, "points": np.round(simplified(c.points), 4).tolist()} for c in curves]
    path.write_text(json.dumps({"curves": entries}, separators=(",", ":")))


def total_length(curves):
    return sum(np.linalg.norm(np.diff(c.points, axis=0), axis=1).sum() for c in curves)


def visible_parts(curves, visible):
    """The visible truth; parts of a closed curve that touch at its start are joined."""
    result = []
    for curve, flags in zip(curves, visible):
        points = curve.points
        if np.allclose(points[0], points[-1]) and flags[0] and flags[-1] and not flags.all():
            start = int(np.argmin(flags))
            points = np.concatenate([points[start:-1], points[:start + 1]])
            flags = np.concatenate([flags[start:-1], flags[:start + 1]])
        result += [Curve(points[a:b + 1], curve.kind, curve.owner) for a, b in index_runs(flags)]
    return result


def write_set(name, sample, caster, solids, curves, occlusion, contours):
    folder = sample / "truth" / FOLDERS[name]
    paths = [sample / name / "images" / scene.view_name(view) for view in range(scene.VIEW_COUNT)]
    counts = visibility.shown_counts(curves, occlusion, paths)
    visible = [visibility.visible_samples(count) for count in counts]
    write(folder / "curves-visible.ply", visible_parts(curves, visible),
          f"true curves seen in at least {visibility.MIN_VIEWS} images of the set {name}")
    found = find_junctions(curves, visible)
    low, high = scene.REGION_OF_INTEREST
    (folder / "junctions.json").write_text(json.dumps(
        {"set": name, "region_of_interest": [low, high], "junctions": found}, indent=1) + "\n")
    degrees = [j["degree"] for j in found]
    print(f"{name}: junctions by degree", {d: degrees.count(d) for d in sorted(set(degrees))},
          {k: sum(j["kind"] == k for j in found) for k in ("corner", "t", "crossing")})
    shadows = [c for light in LIGHTS_OF_SET[name] for c in shadow_curves(caster, solids, curves, light)]
    write_kinds(folder / "kinds.json", visible_parts(curves, visible) + shadows + contours)
    write(folder / "dont-care.ply", shadows + contours,
          "no part of the truth: cast shadows, occluding contours of smooth bodies per view")


def write_depth_maps(folder, caster):
    width, height = int(scene.WIDTH * DEPTH_SCALE), int(scene.HEIGHT * DEPTH_SCALE)
    columns, rows = np.meshgrid(np.arange(width, dtype=float), np.arange(height, dtype=float))
    for view in range(scene.VIEW_COUNT):
        center, rays = cameras.pixel_rays(columns.ravel(), rows.ravel(), view, DEPTH_SCALE)
        length = np.linalg.norm(rays, axis=1)
        distance = caster.distances(center, rays / length[:, None])
        depth = np.where(np.isfinite(distance), distance / length, 0.0)
        write_depth_map(folder / f"{scene.view_name(view)}.geometric.bin", depth.reshape(height, width))


def main():
    arguments = parse_arguments()
    solids = scene.solids()
    caster = RayCaster(solids)
    curves = scene_curves(solids)
    write(arguments.sample / "truth" / "curves.ply", curves, "all true curves, seen or not")
    if arguments.depth:
        write_depth_maps(arguments.sample / "day" / "stereo" / "depth_maps", caster)
    occlusion = visibility.occlusion_table(caster, curves, scene.VIEW_COUNT)
    contours = contour_curves(caster, solids, scene.VIEW_COUNT)
    for name in arguments.sets.split(","):
        write_set(name, arguments.sample, caster, solids, curves, occlusion, contours)


if __name__ == "__main__":
    try:
        main()
    except Exception:
        import traceback
        traceback.print_exc()
        sys.exit(1)
