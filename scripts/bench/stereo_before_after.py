#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what cameras are worth for dense stereo: the same matcher on the same pairs with exact cameras and with others.

    stereo_before_after.py --workspace_path WORKSPACE --model given=NOISY/sparse/0 --model refined=OUT/refined \\
        --output_path FOLDER [--depth_range 1.2,7] [--baseline 0.3,1.2] [--planes x=0,z=2.6] [--database_path DB]

WORKSPACE has photographs and the exact model, of PINHOLE or SIMPLE_PINHOLE cameras (colmap image_undistorter makes such).
COLMAP's patch_match_stereo needs CUDA, so OpenCV's semi-global matcher stands in for it: neighboring views (chosen by the
exact cameras, the same for all models) are rectified by the cameras of a model, matched and left-right checked, and the
disparities become depths of pixels of the first view. Pixels are those of a grid that have texture around them.

Written to FOLDER/stereo.json and stereo.md, per model:
  matched      share of the pixels that have a depth
  right        share of the pixels with a reference whose depth is within 1 % of it; without a match is not right
  error        |depth - reference| / reference, median and 90 %, of the pixels that also exact cameras match
  layers       (largest - smallest depth) / median of a pixel with depths of two pairs or more, median and 90 %
  confirmed    share of the pixels of views with two pairs or more that have two depths or more, all within 1 %
  plane        distance of points to the true plane that they are on, median and 90 %, after the similarity between the
               centers of the cameras and the exact ones; in the unit of the model
  walls_apart  standard deviation, over pairs, of the median signed distance to a plane: the layers of fused clouds

The reference is stereo/depth_maps/*.geometric.bin of WORKSPACE if they are there; they must be exact (the sample scene's are).
Else it is the median over pairs of what the exact cameras give: they then have no error, and what is right with them is the
most that can be. A point is on a plane if the reference is within 0.02 units of it; without depth maps this favors the exact
cameras.

With --database_path (features and verified matches of the photographs; camera of the exact model), COLMAP's point_triangulator,
which leaves cameras alone, also runs on each model. sparse.json and sparse.md have the number of points and observations, mean
length of tracks, mean reprojection error, the distance between the points that a feature got with these cameras and with exact
ones (away, median and 90 %, after the similarity), and how many points are within 0.01 units of a plane.
"""

import argparse
import json
import os
import struct
import subprocess
from pathlib import Path

import cv2
import numpy as np

from camera_poses import read_cameras, read_images, similarity

GRID_PX = 4  # of the pixels that are judged
MIN_TEXTURE, TEXTURE_PX = 4, 9  # standard deviation in gray levels, window
MAX_AXES_DEG, MAX_TURN_DEG = 40, 35  # between the views of a pair; from them to the rectified ones
PAIRS_PER_VIEW = 3
MAX_TANGENT = 1.5  # of what is matched, from the axis of the rectified views
MIN_SHARE = 0.4  # of the first view that the second shows too
RIGHT = 0.01
ON_PLANE = 0.02  # in the unit of the exact model
MIN_ON_PLANE = 100  # pixels of a pair


class View:
    """A pinhole camera; pixels as in OpenCV, the center of the first one is (0, 0)."""

    def __init__(self, name, size, intrinsics, rotation, translation):
        self.name, self.size, self.intrinsics, self.rotation = name, size, intrinsics, rotation
        self.center = -self.rotation.T @ translation


def read_model(folder):
    """Views by name."""
    views, cameras = {}, read_cameras(folder / "cameras.bin")
    for name, (rotation, translation, camera) in read_images(folder / "images.bin").items():
        model, size, (*focal, x, y) = cameras[camera]
        if model not in ("SIMPLE_PINHOLE", "PINHOLE"):
            raise SystemExit(f"ERROR: {folder / 'cameras.bin'}: cameras must be PINHOLE or SIMPLE_PINHOLE (colmap image_undistorter)")
        intrinsics = np.array([[focal[0], 0, x - 0.5], [0, focal[-1], y - 0.5], [0, 0, 1]])
        views[name] = View(name, size, intrinsics, rotation, translation)
    return views


def read_depth_map(path):
    data = path.read_bytes()
    width, height, _, values = data.split(b"&", 3)
    return np.frombuffer(values, "<f4").reshape(int(height), int(width)).astype(float)


def similarity_of(views, exact):
    """(scale, rotation, translation) from the frame of the views to the exact one."""
    names = sorted(set(views) & set(exact))
    return similarity(*(np.array([model[name].center for name in names]) for model in (views, exact)))


def grid_of(view):
    """Pixels that are judged, as homogeneous columns, and the shape of their grid.

    They are those of depth maps of COLMAP at a quarter of the size: (column, row) there is on the ray through (4 column, 4 row)
    of the image, where centers of pixels are at 0.5.
    """
    width, height = view.size[0] // GRID_PX, view.size[1] // GRID_PX
    columns, rows = np.meshgrid(np.arange(width), np.arange(height))
    pixels = np.stack([columns.ravel(), rows.ravel()]) * GRID_PX - 0.5
    return np.vstack([pixels, np.ones(pixels.shape[1])]), (height, width)


def sampled(image, pixels, outside):
    """Values of an image at the nearest pixels; homogeneous pixels, where the third coordinate must be positive."""
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = np.rint(np.where(pixels[2] > 0, pixels[:2] / pixels[2], -1e6)).clip(-1e6, 1e6).astype(int)
    inside = (x >= 0) & (y >= 0) & (x < image.shape[1]) & (y < image.shape[0])
    return np.where(inside, image[y * inside, x * inside], outside)


def textured(image):
    """Pixels of an image that have texture around them."""
    gray = image.astype(np.float32)
    mean, square = (cv2.blur(values, (TEXTURE_PX, TEXTURE_PX)) for values in (gray, gray * gray))
    return square - mean * mean >= MIN_TEXTURE**2


def rectified_axes(first, second):
    """Rows: the baseline, then as little turned from the mean axis of the two views as can be."""
    x = (second.center - first.center) / np.linalg.norm(second.center - first.center)
    mean = first.rotation[2] + second.rotation[2]
    z = mean - mean @ x * x
    z /= np.linalg.norm(z)
    return np.array([x, np.cross(z, x), z])


def angle_deg(a, b):
    return np.degrees(np.arccos(np.clip(a @ b / np.linalg.norm(a) / np.linalg.norm(b), -1, 1)))


def overlap(first, second, depth):
    """Share of the first view that the second shows, for a scene at that depth."""
    pixels, _ = grid_of(first)
    rays = first.rotation.T @ np.linalg.inv(first.intrinsics) @ pixels
    seen = second.intrinsics @ second.rotation @ (first.center[:, None] + depth * rays - second.center[:, None])
    x, y = seen[:2] / seen[2]
    return np.mean((seen[2] > 0) & (x >= 0) & (y >= 0) & (x < second.size[0]) & (y < second.size[1]))


def pairs_of(views, baseline, depth_range):
    """Ordered pairs of names."""
    pairs, depth = [], np.sqrt(depth_range[0] * depth_range[1])
    for first in sorted(views.values(), key=lambda view: view.name):
        found = []
        for second in views.values():
            length = np.linalg.norm(second.center - first.center)
            if not baseline[0] <= length <= baseline[1]:
                continue
            turn = max(angle_deg(rectified_axes(first, second)[2], view.rotation[2]) for view in (first, second))
            share = overlap(first, second, depth)
            if angle_deg(first.rotation[2], second.rotation[2]) <= MAX_AXES_DEG and turn <= MAX_TURN_DEG and share >= MIN_SHARE:
                found.append((-share, second.name))
        pairs += [(first.name, name) for _, name in sorted(found)[:PAIRS_PER_VIEW]]
    return pairs


def turned_bounds(view, axes):
    """Bounds (x0, y0, x1, y1) of an image turned to these axes, in focal lengths; what is turned far aside is cut off."""
    width, height = view.size
    border = np.array([(x, y, 1) for x in np.linspace(0, width - 1, 9) for y in np.linspace(0, height - 1, 9)]).T
    rays = axes @ view.rotation.T @ np.linalg.inv(view.intrinsics) @ border
    points = np.clip(rays[:2] / np.maximum(rays[2], 1e-3), -MAX_TANGENT, MAX_TANGENT)
    return np.concatenate([points.min(1), points.max(1)])


def disparities(left, right, nearest, farthest):
    """Left-right checked; nan where there are none."""
    least = int(np.floor(farthest))
    count = 16 * int(np.ceil((nearest - least) / 16))
    # The check of OpenCV itself is off: it compares with what only the left image tells.
    matcher = cv2.StereoSGBM_create(least, count, 5, 8 * 25, 32 * 25, disp12MaxDiff=-1, preFilterCap=31, uniquenessRatio=10,
                                    speckleWindowSize=50, speckleRange=2)

    def matched(a, b):
        pad = [np.pad(image, ((0, 0), (max(least + count, 0), max(-least, 0)))) for image in (a, b)]
        found = matcher.compute(*pad)[:, max(least + count, 0):][:, :a.shape[1]].astype(float) / 16
        return np.where(found < least, np.nan, found)
    found = matched(left, right)
    back = matched(right[:, ::-1].copy(), left[:, ::-1].copy())[:, ::-1]
    rows, columns = np.nonzero(np.isfinite(found))
    there = np.rint(columns - found[rows, columns]).astype(int)
    inside = (there >= 0) & (there < left.shape[1])
    agree = inside & (np.abs(back[rows, np.where(inside, there, 0)] - found[rows, columns]) <= 1)
    found[rows[~agree], columns[~agree]] = np.nan
    return found


def stereo_depths(first, second, images, depth_range):
    """Depths along the axis of the first view at its grid; nan where there are none."""
    axes = rectified_axes(first, second)
    focal = (first.intrinsics[0, 0] + second.intrinsics[0, 0]) / 2
    bounds = [turned_bounds(view, axes) for view in (first, second)]
    y0, y1 = max(b[1] for b in bounds), min(b[3] for b in bounds)
    width = int(focal * max(b[2] - b[0] for b in bounds)) + 1
    height = int(focal * (y1 - y0)) + 1
    warps = [np.array([[focal, 0, -focal * b[0]], [0, focal, -focal * y0], [0, 0, 1]]) @ axes @ view.rotation.T
             @ np.linalg.inv(view.intrinsics) for b, view in zip(bounds, (first, second))]
    left, right = (cv2.warpPerspective(images[view.name], warp, (width, height)) for warp, view in zip(warps, (first, second)))
    scale, shift = focal * np.linalg.norm(second.center - first.center), focal * (bounds[1][0] - bounds[0][0])
    found = disparities(left, right, scale / depth_range[0] + shift, scale / depth_range[1] + shift) - shift
    pixels, shape = grid_of(first)
    turned = warps[0] @ pixels
    with np.errstate(divide="ignore", invalid="ignore"):
        depths = scale / sampled(found, turned, np.nan) / turned[2]
    depths[~((depths >= depth_range[0]) & (depths <= depth_range[1]))] = np.nan
    return depths.reshape(shape)


def all_depths(views, pairs, images, exact, depth_range):
    """Per pair, in the unit of the exact model."""
    scale = similarity_of(views, exact)[0]
    return [scale * stereo_depths(views[first], views[second], images, np.array(depth_range) / scale) for first, second in pairs]


def points_of(view, depths, transform):
    """3 x pixels in the frame of the exact model, of depths in its unit."""
    scale, rotation, translation = transform
    rays = view.rotation.T @ np.linalg.inv(view.intrinsics) @ grid_of(view)[0]
    return rotation @ (scale * view.center[:, None] + depths.ravel() * rays) + translation[:, None]


def nearest_plane(points, planes, limit):
    """Index of the plane within the limit of points (3 x n), or -1."""
    distances = np.abs(np.array([points[axis] - at for axis, at in planes]))
    distances[np.isnan(distances)] = np.inf
    return np.where(distances.min(0) <= limit, distances.argmin(0), -1)


def quantiles(values):
    values = np.concatenate([np.ravel(v) for v in values]) if len(values) else np.array([])
    return [float(q) for q in np.quantile(values, [0.5, 0.9])] if values.size else [None, None]


class Judge:
    """What depths are compared with; `depths` are those with the exact cameras."""

    def __init__(self, exact, pairs, images, depths, arguments):
        self.exact, self.pairs, self.exact_depths, self.planes = exact, pairs, depths, arguments.planes
        self.has_truth = (arguments.workspace_path / "stereo/depth_maps").is_dir()
        self.masks, self.references, self.labels = {}, {}, {}
        for name in sorted({first for first, _ in pairs}):
            pixels, shape = grid_of(exact[name])
            self.masks[name] = sampled(textured(images[name]), pixels, False).reshape(shape)
            self.references[name] = self.reference(name, arguments.workspace_path)
            if self.planes:
                points = points_of(exact[name], self.references[name], (1, np.eye(3), np.zeros(3)))
                self.labels[name] = nearest_plane(points, self.planes, ON_PLANE)

    def reference(self, name, workspace):
        """Depths at the grid of a view; nan where unknown."""
        if not self.has_truth:
            return median_depth(self.of_view(name, self.exact_depths))
        depth = read_depth_map(workspace / "stereo/depth_maps" / f"{name}.geometric.bin")
        if depth.shape != self.masks[name].shape:
            raise SystemExit(f"ERROR: stereo/depth_maps: {name}: must be a quarter of the size of the image")
        return np.where(depth > 0, depth, np.nan)

    def of_view(self, name, depths):
        return np.array([depth for (first, _), depth in zip(self.pairs, depths) if first == name])

    def figures(self, views, depths):
        figures = {**self.matches(depths), **self.layers(depths)}
        if depths is self.exact_depths and not self.has_truth:
            figures["error"] = [None, None]
        return {**figures, **(self.plane_figures(views, depths) if self.planes else {})}

    def matches(self, depths):
        pixels, matched, known, right, errors = 0, 0, 0, 0, []
        for (first, _), depth, of_exact in zip(self.pairs, depths, self.exact_depths):
            mask = self.masks[first]
            reference = self.references[first][mask]
            error = np.abs(depth[mask] - reference) / reference
            pixels += mask.sum()
            matched += np.isfinite(depth[mask]).sum()
            known += np.isfinite(reference).sum()
            right += (error <= RIGHT).sum()
            errors.append(error[np.isfinite(error) & np.isfinite(of_exact[mask])])
        return {"pairs": len(depths), "pixels": int(pixels), "matched": float(matched / pixels), "right": float(right / known),
                "error": quantiles(errors)}

    def layers(self, depths):
        """How far depths of a pixel, of different pairs, are apart."""
        spreads, num_pixels = [], 0
        for name, mask in self.masks.items():
            stack = self.of_view(name, depths)[:, mask]
            if len(stack) >= 2:
                num_pixels += stack.shape[1]
                twice = stack[:, np.isfinite(stack).sum(0) >= 2]
                spreads.append((np.nanmax(twice, 0) - np.nanmin(twice, 0)) / np.nanmedian(twice, 0))
        confirmed = sum((values <= RIGHT).sum() for values in spreads)
        return {"layers": quantiles(spreads), "confirmed": float(confirmed / max(num_pixels, 1))}

    def plane_figures(self, views, depths):
        transform, distances, offsets = similarity_of(views, self.exact), [], [[] for _ in self.planes]
        for (first, _), depth in zip(self.pairs, depths):
            points = points_of(views[first], depth, transform)
            for k, (axis, at) in enumerate(self.planes):
                signed = (points[axis] - at)[(self.labels[first] == k) & self.masks[first].ravel()]
                signed = signed[np.isfinite(signed)]
                distances.append(np.abs(signed))
                if len(signed) >= MIN_ON_PLANE:
                    offsets[k].append(np.median(signed))
        centered = np.concatenate([values - np.mean(values) for values in offsets if values] or [[np.nan]])
        return {"plane": quantiles(distances), "walls_apart": float(np.sqrt(np.mean(centered**2)))}


def median_depth(stack):
    unknown = ~np.isfinite(stack).any(0)
    return np.where(unknown, np.nan, np.nanmedian(np.where(unknown, 0, stack), 0))


def read_points(path):
    """Positions (n x 3), reprojection errors, and (index of the point, image, feature) of what tracks have."""
    positions, errors, tracks = [], [], []
    with open(path, "rb") as file:
        for index in range(*struct.unpack("<Q", file.read(8))):
            _, x, y, z, _, _, _, error, length = struct.unpack("<Q3d3BdQ", file.read(51))
            positions.append((x, y, z))
            errors.append(error)
            tracks += [(index, *seen) for seen in struct.iter_unpack("<2I", file.read(8 * length))]
    return np.array(positions).reshape(-1, 3), np.array(errors), tracks


def without_points(model, folder):
    """The model in the folder, without points and what the images see of them."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "cameras.bin").write_bytes((model / "cameras.bin").read_bytes())
    (folder / "points3D.bin").write_bytes(struct.pack("<Q", 0))
    with open(model / "images.bin", "rb") as source, open(folder / "images.bin", "wb") as target:
        count = source.read(8)
        target.write(count)
        for _ in range(*struct.unpack("<Q", count)):
            target.write(source.read(64) + b"".join(iter(lambda: source.read(1), b"\0")) + b"\0" + struct.pack("<Q", 0))
            source.seek(24 * struct.unpack("<Q", source.read(8))[0], os.SEEK_CUR)
    return folder


def triangulate(model, arguments, folder):
    """COLMAP's points of a model."""
    output = folder / "triangulated"
    output.mkdir(parents=True, exist_ok=True)
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    subprocess.run(["colmap", "point_triangulator", "--database_path", arguments.database_path,
                    "--image_path", arguments.workspace_path / "images", "--input_path", without_points(model, folder / "model"),
                    "--output_path", output], check=True, stdout=subprocess.DEVNULL)
    return read_points(output / "points3D.bin")


def compare_points(models, folders, arguments):
    """What COLMAP triangulates with the cameras of each model; the exact one is the first."""
    results, of_exact = {}, None
    for label, views in models.items():
        positions, errors, tracks = triangulate(folders[label], arguments, arguments.output_path / label)
        scale, rotation, translation = similarity_of(views, models["exact"])
        positions = scale * positions @ rotation.T + translation
        of_feature = {(image, feature): positions[index] for index, image, feature in tracks}
        of_exact = of_exact or of_feature
        away = [np.linalg.norm(position - of_exact[seen]) for seen, position in of_feature.items() if seen in of_exact]
        results[label] = {"points": len(positions), "observations": len(tracks), "track": len(tracks) / len(positions),
                          "reprojection_px": float(np.average(errors, weights=np.bincount([t[0] for t in tracks]))),
                          "away": quantiles([away])}
        if arguments.planes:
            distances = np.abs(np.array([positions[:, axis] - at for axis, at in arguments.planes])).min(0)
            results[label]["on_planes"] = int((distances <= ON_PLANE / 2).sum())
        write_results(arguments.output_path, "sparse", results)


FORMATS = {**dict.fromkeys(["matched", "right", "confirmed"], "{:.1%}"), **dict.fromkeys(["error", "layers"], "{:.2%}"),
           **dict.fromkeys(["plane", "walls_apart", "away"], "{:.4f}"), **dict.fromkeys(["track", "reprojection_px"], "{:.3f}")}


def text_of(key, value):
    if isinstance(value, list):
        return " / ".join(text_of(key, number) for number in value)
    return "-" if value is None else FORMATS.get(key, "{:,}").format(value)


def write_results(folder, name, results):
    keys = list(next(iter(results.values())))
    rows = [["cameras", *keys], ["---"] * (len(keys) + 1)]
    rows += [[label, *(text_of(key, figures[key]) for key in keys)] for label, figures in results.items()]
    text = "".join(f"| {' | '.join(row)} |\n" for row in rows)
    (folder / f"{name}.md").write_text(text, encoding="utf-8")
    (folder / f"{name}.json").write_text(json.dumps(results, indent=1), encoding="utf-8")
    print(text)


def compare_stereo(models, arguments):
    """Depths with the cameras of each model; the exact one is the first."""
    exact = models["exact"]
    pairs = pairs_of(exact, arguments.baseline, arguments.depth_range)
    if not pairs:
        raise SystemExit("ERROR: no pairs with such a --baseline")
    images = {name: cv2.imread(str(arguments.workspace_path / "images" / name), cv2.IMREAD_GRAYSCALE) for name in exact}
    results, judge = {}, None
    for label, views in models.items():
        depths = all_depths(views, pairs, images, exact, arguments.depth_range)
        judge = judge or Judge(exact, pairs, images, depths, arguments)
        results[label] = judge.figures(views, depths)
        write_results(arguments.output_path, "stereo", results)


def parsed():
    def interval(text):
        low, high = map(float, text.split(","))
        return low, high

    def planes(text):
        return [("xyz".index(word[0]), float(word[2:])) for word in text.split(",")]

    def model(text):
        label, path = text.split("=", 1)
        return label, Path(path)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--workspace_path", type=Path, required=True, help="photographs and the exact model")
    parser.add_argument("--model", type=model, action="append", default=[], metavar="LABEL=FOLDER")
    parser.add_argument("--output_path", type=Path, required=True)
    parser.add_argument("--depth_range", type=interval, default=(1.2, 7), help="that is searched, in the unit of the exact model")
    parser.add_argument("--baseline", type=interval, default=(0.3, 1.2), help="least and most of a pair")
    parser.add_argument("--planes", type=planes, default=[], help="true planes across the axes: x=0,x=5,z=2.6")
    parser.add_argument("--database_path", type=Path, help="of COLMAP, with matches: also triangulates points")
    return parser.parse_args()


def main():
    arguments = parsed()
    arguments.output_path.mkdir(parents=True, exist_ok=True)
    sparse = arguments.workspace_path / "sparse"
    folders = {"exact": sparse / "0" if (sparse / "0").exists() else sparse, **dict(arguments.model)}
    models = {label: read_model(folder) for label, folder in folders.items()}
    if arguments.database_path:
        compare_points(models, folders, arguments)
    compare_stereo(models, arguments)


if __name__ == "__main__":
    main()
