#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""draw_picture.py PICTURE.jpg DRAWING.svg [PHOTOGRAPH ...]: a drawing, with the photographs on its left, in a column."""

import sys
from pathlib import Path

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pictures import read, svg, write  # noqa: E402

WIDTH = 1200


def of_height(image, height):
    width = round(image.shape[1] * height / image.shape[0])
    return cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA)


def column(images, height):
    """Of this height, made of equal parts but for rounding."""
    ends = np.linspace(0, height, len(images) + 1).round().astype(int)
    parts = [of_height(image, end - begin) for image, begin, end in zip(images, ends, ends[1:])]
    width = min(part.shape[1] for part in parts)
    return np.vstack([part[:, :width] for part in parts])


picture, drawing, *photographs = map(Path, sys.argv[1:])
image = svg(drawing)
if photographs:
    image = np.hstack([column([read(photograph) for photograph in photographs], image.shape[0]), image])
write(picture, image, WIDTH)
