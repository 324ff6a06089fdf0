# SPDX-License-Identifier: BSD-3-Clause
"""Projection with the pinhole and the distorted camera, COLMAP's pixel convention. Needs numpy only."""

import numpy as np

import lens
import scene


def project(points, index, distorted=False):
    """Pixel positions (N x 2) and depths (N) of world points in a view."""
    rotation, translation = scene.camera_pose(index)
    local = points @ rotation.T + translation
    depth = local[:, 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        flat = local[:, :2] / depth[:, None]
        if distorted:
            return lens.distort(flat) * lens.FOCAL_PX + lens.PRINCIPAL_POINT, depth
        return flat * scene.FOCAL_PX + scene.PRINCIPAL_POINT, depth


def in_image(pixels, depth, margin):
    """Which projections lie in the image, at least `margin` pixels from its border."""
    x, y = pixels.T
    return ((depth > 0) & (x > margin) & (x < scene.WIDTH - margin)
            & (y > margin) & (y < scene.HEIGHT - margin))


def pixel_rays(columns, rows, index, scale):
    """Camera center and directions with unit depth through (column, row) of a map `scale` times the image.

    No half pixel is added: COLMAP's dense stage back-projects depth pixel (c, r) as K^-1 (c, r, 1).
    """
    rotation, _ = scene.camera_pose(index)
    cx, cy = scene.PRINCIPAL_POINT
    focal = scene.FOCAL_PX * scale
    local = np.stack([(columns - cx * scale) / focal, (rows - cy * scale) / focal, np.ones(columns.shape)], -1)
    return scene.camera_center(index), local @ rotation
