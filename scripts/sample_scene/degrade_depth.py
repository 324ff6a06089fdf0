#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Simulates real dense results from the exact depth maps of the sample scene.

    degrade_depth.py datasets/sample/day OUT [--exact]

Makes OUT a dense workspace of COLMAP: links to images and model, and in stereo/ depth and normal maps
with the artifacts of multi-view stereo:
  - holes where the image is flat and nothing can be matched;
  - fattened edges: near surfaces extend over far ones by half a matching window;
  - smoothed edges: a matching window mixes the depths it covers;
  - noise, smooth over a few pixels, and stray depths.
With --exact the depths stay as they are and only get normals. Needs numpy and OpenCV. The same input gives the same output.
"""

import argparse
import os
from pathlib import Path

import cv2
import numpy as np

SEED = 7
FLAT_GRAY_LEVELS = 30.0  # range of gray levels within a window below which nothing matches
FLAT_HOLE_SHARE = 0.85  # of the flat pixels
WINDOW = 5  # matching window, pixels of the map
FATTEN = 1  # pixels of the map
NOISE_FOOTPRINTS = 1.0  # standard deviation of depth, pixels of the map
STRAY_SHARE = 0.003
FAR = 1e6  # beyond all depths


def read_map(path):
    data = path.read_bytes()
    fields, rest = data.split(b"&", 3)[:3], data.split(b"&", 3)[3]
    width, height, channels = map(int, fields)
    return np.frombuffer(rest, "<f4").reshape(channels, height, width)[0]


def write_map(path, planes):
    path.parent.mkdir(parents=True, exist_ok=True)
    channels, height, width = planes.shape
    path.write_bytes(f"{width}&{height}&{channels}&".encode() + planes.astype("<f4").tobytes())


def flat_pixels(image, shape):
    """True where a window of the image has nothing to match."""
    gray = cv2.resize(image, shape[::-1], interpolation=cv2.INTER_AREA).astype(np.float32)
    window = np.ones((WINDOW, WINDOW), np.uint8)
    return cv2.dilate(gray, window) - cv2.erode(gray, window) < FLAT_GRAY_LEVELS


def smooth_noise(random, shape):
    """Standard normal, alike within a window."""
    noise = cv2.GaussianBlur(random.standard_normal(shape).astype(np.float32), (0, 0), 1.0)
    return noise / noise.std()


def blotches(random, shape, share):
    """True in this share of the pixels, in coherent spots."""
    noise = smooth_noise(random, shape)
    return noise < np.quantile(noise, share)


def degrade(depth, image, focal, random):
    """The depth map that stereo would have made; 0 = unknown."""
    known = depth > 0
    far = np.where(known, depth, FAR).astype(np.float32)
    result = cv2.erode(far, np.ones((2 * FATTEN + 1, 2 * FATTEN + 1), np.uint8))
    result[result >= FAR] = 0
    blurred = cv2.blur(result, (3, 3))
    same_surface = np.abs(blurred - result) < 0.02 * np.maximum(result, 1e-6)
    result = np.where(same_surface, blurred, result)
    result *= 1 + NOISE_FOOTPRINTS / focal * smooth_noise(random, depth.shape)
    holes = flat_pixels(image, depth.shape) & blotches(random, depth.shape, FLAT_HOLE_SHARE)
    stray = random.random(depth.shape) < STRAY_SHARE
    result[stray] *= random.uniform(0.7, 1.3, stray.sum())
    result[holes | ~known] = 0
    return result


def normals_of(depth, focal, center):
    """Unit normals in the camera frame, towards the camera, from the neighboring depths."""
    rows, columns = np.indices(depth.shape, dtype=np.float64)
    smooth = np.where(depth > 0, cv2.GaussianBlur(depth, (0, 0), 1.0), 0)
    points = np.stack([(columns - center[0]) / focal * smooth, (rows - center[1]) / focal * smooth, smooth])
    along_x = np.gradient(points, axis=2)
    along_y = np.gradient(points, axis=1)
    normals = np.cross(along_x, along_y, axis=0)
    length = np.linalg.norm(normals, axis=0)
    normals = np.where(length > 0, normals / np.maximum(length, 1e-30), 0)
    away = np.sum(normals * points, axis=0) > 0
    normals[:, away] *= -1
    normals[:, (depth <= 0)] = 0
    return normals


def read_camera(path):
    """Width, focal length and principal point of the only camera, a PINHOLE."""
    data = path.read_bytes()
    width = int(np.frombuffer(data, "<u8", 1, 16)[0])
    focal, _, cx, cy = np.frombuffer(data, "<f8", 4, 32)
    return width, focal, np.array([cx, cy])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("workspace", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--exact", action="store_true")
    arguments = parser.parse_args()
    random = np.random.default_rng(SEED)
    width, focal, center = read_camera(arguments.workspace / "sparse" / "cameras.bin")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in ("images", "sparse"):
        link = arguments.out / name
        if not link.exists():
            os.symlink((arguments.workspace / name).resolve(), link)
    names = sorted(p.name for p in (arguments.workspace / "images").iterdir())
    stereo = arguments.out / "stereo"
    for name in names:
        exact = read_map(arguments.workspace / "stereo" / "depth_maps" / f"{name}.geometric.bin")
        scale = exact.shape[1] / width
        image = cv2.imread(str(arguments.workspace / "images" / name), cv2.IMREAD_GRAYSCALE)
        depth = exact if arguments.exact else degrade(exact, image, focal * scale, random)
        normals = normals_of(depth, focal * scale, center * scale)
        write_map(stereo / "depth_maps" / f"{name}.geometric.bin", depth[None])
        write_map(stereo / "normal_maps" / f"{name}.geometric.bin", normals)
    (stereo / "fusion.cfg").write_text("".join(f"{name}\n" for name in names))
    (stereo / "patch-match.cfg").write_text("".join(f"{name}\n__auto__, 20\n" for name in names))


if __name__ == "__main__":
    main()
