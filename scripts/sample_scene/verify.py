# SPDX-License-Identifier: BSD-3-Clause
"""Measures how well the projected truth agrees with edges of the committed images. Runs inside Blender.

  blender --background --python verify.py -- --sample datasets/sample --sets day,distorted [--overlays /tmp/overlays]

For every unoccluded sample of the visible truth the gradient's maximum is located along the normal of the
projected curve. Printed: medians of the offset towards the brighter side, the spread, and the common shift
(dx, dy) that would explain the offsets. Measured in linear light (the gamma of gray levels moves the maximum
of an edge's gradient towards the dark side) and in the stored gray levels.
"""

import argparse
import sys
from pathlib import Path

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import cameras  # noqa: E402
import scene  # noqa: E402
import visibility  # noqa: E402
from colmap_files import read_curves  # noqa: E402
from geometry import Curve  # noqa: E402
from raycast import RayCaster  # noqa: E402
from truth import FOLDERS  # noqa: E402
from truth_curves import resample  # noqa: E402

SIGMA_PX = 1.0
SEARCH_PX = 1.5
STEP_PX = 0.1


def linear_light(image):
    """sRGB gray levels (0..255) to linear light on the same range."""
    v = image / 255.0
    return 255.0 * np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def gray_image(path, linear):
    image = cv2.imread(str(path)).astype(np.float64)
    if linear:
        image = linear_light(image)
    return (image @ (0.114, 0.587, 0.299)).astype(np.float32)


def edge_offsets(image, pixels, normals):
    """Signed offset (px, along the normal turned to the brighter side) of the gradient's maximum; NaN: none."""
    smooth = cv2.GaussianBlur(image, (0, 0), SIGMA_PX)
    gx, gy = cv2.Sobel(smooth, cv2.CV_32F, 1, 0, ksize=1) / 2, cv2.Sobel(smooth, cv2.CV_32F, 0, 1, ksize=1) / 2
    reach = np.arange(-SEARCH_PX - 0.5, SEARCH_PX + 0.5001, STEP_PX)
    where = pixels[:, None] + reach[None, :, None] * normals[:, None] - 0.5
    x, y = where[..., 0].astype(np.float32), where[..., 1].astype(np.float32)
    gradient = np.stack([cv2.remap(g, x, y, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE) for g in (gx, gy)], -1)
    across = np.einsum("nki,ni->nk", gradient, normals)
    sign = np.sign(across[:, len(reach) // 2])
    across = across * sign[:, None]
    best = np.argmax(across, axis=1)
    rows = np.arange(len(best))
    inside = (best > 5) & (best < len(reach) - 6)
    best = np.clip(best, 1, len(reach) - 2)
    left, middle, right = across[rows, best - 1], across[rows, best], across[rows, best + 1]
    bend = left - 2 * middle + right
    shift = np.where(bend < 0, 0.5 * (left - right) / np.where(bend < 0, bend, 1), 0.0)
    ok = inside & (middle > 4.0) & (bend < 0)
    return np.where(ok, (reach[best] + shift * STEP_PX) * sign, np.nan), sign


def offsets_of_set(name, sample, caster, curves, linear):
    distorted = name == "distorted"
    offsets, directions, positions = [], [], []
    for view in range(scene.VIEW_COUNT):
        image = gray_image(sample / name / "images" / scene.view_name(view), linear)
        for curve in curves:
            seen, pixels = visibility.unoccluded(caster, curve.points, view, distorted)
            if seen.any():
                normals = visibility.image_normals(curve.points, view, distorted)[seen]
                offset, sign = edge_offsets(image, pixels[seen], normals)
                ok = np.isfinite(offset)
                offsets.append((offset * sign)[ok])
                directions.append((normals * sign[:, None])[ok])
                positions.append(pixels[seen][ok])
    return np.concatenate(offsets), np.concatenate(directions), np.concatenate(positions)


def report(name, offsets, directions, positions, what):
    shift_x, shift_y, growth = common_motion(offsets, directions, positions)
    x_side = [np.median(offsets[s * directions[:, 0] > 0.9]) for s in (1, -1)]
    y_side = [np.median(offsets[s * directions[:, 1] > 0.9]) for s in (1, -1)]
    print(f"{name} ({what}): {len(offsets)} samples, median offset towards bright {np.median(offsets):+.3f} px, "
          f"median |offset| {np.median(np.abs(offsets)):.3f}; bright side right {x_side[0]:+.3f}, "
          f"left {x_side[1]:+.3f}, below {y_side[0]:+.3f}, above {y_side[1]:+.3f}; common shift "
          f"({shift_x:+.3f}, {shift_y:+.3f}) px, radial growth at the corners {growth:+.3f} px")


def common_motion(offsets, directions, positions):
    """Shift (px) and cubic radial growth (px at the image's corners) that best explain the offsets; robust."""
    from_center = (positions - (scene.WIDTH / 2, scene.HEIGHT / 2)) / (np.hypot(scene.WIDTH, scene.HEIGHT) / 2)
    radial = np.einsum("ij,ij->i", from_center, directions) * np.sum(from_center**2, axis=1)
    design = np.column_stack([directions, radial, np.ones(len(offsets))])
    solution = np.zeros(4)
    for _ in range(10):
        keep = np.abs(offsets - design @ solution) < 0.3
        solution = np.linalg.lstsq(design[keep], offsets[keep], rcond=None)[0]
    return solution[:3]


def draw_overlays(folder, name, sample, caster, curves, color, scale=2):
    folder.mkdir(parents=True, exist_ok=True)
    for view in range(0, scene.VIEW_COUNT, 5):
        image = cv2.imread(str(sample / name / "images" / scene.view_name(view)))
        image = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC)
        for curve in curves:
            seen, pixels = visibility.unoccluded(caster, curve.points, view, name == "distorted")
            for x, y in pixels[seen] * scale - 0.5:
                cv2.circle(image, (int(round(x * 8)), int(round(y * 8))), 4, color, -1, cv2.LINE_AA, 3)
        cv2.imwrite(str(folder / f"{name}_{view:02d}.png"), image)


def read_truth(sample, name, file):
    folder = FOLDERS["day" if name == "distorted" else name]
    return [Curve(resample(p, 0.005), "", "") for p in read_curves(sample / "truth" / folder / file)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=Path, required=True)
    parser.add_argument("--sets", default="day,evening,lamp,mixed,distorted")
    parser.add_argument("--overlays", type=Path)
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    caster = RayCaster(scene.solids())
    for name in arguments.sets.split(","):
        curves = read_truth(arguments.sample, name, "curves-visible.ply")
        for linear, what in ((True, "linear light"), (False, "gray levels")):
            report(name, *offsets_of_set(name, arguments.sample, caster, curves, linear), what)
        if arguments.overlays:
            draw_overlays(arguments.overlays, name, arguments.sample, caster, curves, (0, 0, 255))
            draw_overlays(arguments.overlays / "dont-care", name, arguments.sample, caster,
                          read_truth(arguments.sample, name, "dont-care.ply"), (255, 0, 255))


if __name__ == "__main__":
    try:
        main()
    except Exception:
        import traceback
        traceback.print_exc()
        sys.exit(1)
