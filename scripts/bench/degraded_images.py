# SPDX-License-Identifier: BSD-3-Clause
"""Images of a workspace of tests/bench/pose_noise, made larger, smaller or worse. Imported by the other scripts here."""

import shutil

import cv2
import numpy as np

SEED = 1
JPEG_QUALITY = 95


def degraded(image, scale, blur_px, noise, random):
    if scale != 1:
        way = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
        size = [int(scale * side + 0.5) for side in image.shape[1::-1]]  # as pose_noise rounds
        image = cv2.resize(image, size, interpolation=way)
    if blur_px:
        image = cv2.GaussianBlur(image, (0, 0), blur_px)
    if noise:
        image = np.clip(image + random.normal(0, noise, image.shape), 0, 255).round().astype(np.uint8)
    return image


def replace_images(folder, scale=1, blur_px=0, noise=0):
    """Replaces the link to the images of the data set by copies: so many times as large (area averages, cubic), blurred by a Gaussian,
    with independent noise of so many gray levels on every channel; the same bytes every time."""
    originals = (folder / "images").resolve()
    (folder / "images").unlink()
    (folder / "images").mkdir()
    random = np.random.default_rng(SEED)
    for path in sorted(originals.iterdir()):
        target = folder / "images" / path.name
        if scale == 1 and not blur_px and not noise:
            shutil.copy(path, target)
            continue
        image = degraded(cv2.imread(str(path), cv2.IMREAD_COLOR), scale, blur_px, noise, random)
        cv2.imwrite(str(target), image, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
