# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of documents: what the scripts of the tutorial and of the gallery share."""

import subprocess

import cv2
import numpy as np


def write(path, image, width=900):
    """A small JPEG file of this width, px."""
    height = round(image.shape[0] * width / image.shape[1])
    image = cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA)
    if not cv2.imwrite(str(path), image, [cv2.IMWRITE_JPEG_QUALITY, 82]):
        raise SystemExit(f"{path}: cannot be written")


def read(path):
    image = cv2.imread(str(path))
    if image is None:
        raise SystemExit(f"{path}: no picture that can be read")
    return image


def svg(path):
    """Drawn by librsvg on white, 1800 px wide; also as a PNG file beside it."""
    subprocess.run(["rsvg-convert", "--width", "1800", "--background-color", "white", "--output", path.with_suffix(".png"), path], check=True)
    return read(path.with_suffix(".png"))


def grid(images, columns):
    """Of the same size each."""
    rows = [np.hstack(images[i:i + columns]) for i in range(0, len(images), columns)]
    return np.vstack(rows)
