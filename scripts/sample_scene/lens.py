# SPDX-License-Identifier: BSD-3-Clause
"""The lens of the distorted set: COLMAP's OPENCV model, rendered directly by Cycles.

Cycles has a camera whose angle from the axis is a polynomial of degree four in the distance from the image
center. The distorted set therefore needs no resampling: the polynomial is fitted to the inverse of COLMAP's
model, and k1, k2 below were chosen so that the fit is good to about a thousandth of a pixel.
"""

import numpy as np

from scene import HEIGHT, WIDTH

FOCAL_PX = 600.0
K1, K2 = -0.10, 0.08
PRINCIPAL_POINT = (WIDTH / 2.0, HEIGHT / 2.0)


def distort(u):
    """Normalized undistorted to distorted coordinates (N x 2)."""
    r2 = np.sum(u * u, axis=-1, keepdims=True)
    return u * (1 + K1 * r2 + K2 * r2 * r2)


def angle_polynomial():
    """k0..k4 with angle = sum k_i r^i, r in pixels from the image center."""
    limit = np.hypot(WIDTH, HEIGHT) / 2 / FOCAL_PX * 1.12
    angle = np.arctan(np.linspace(0, limit, 4001))[1:]
    u = np.tan(angle)
    r = FOCAL_PX * u * (1 + K1 * u**2 + K2 * u**4)
    keep = r <= np.hypot(WIDTH, HEIGHT) / 2 + 2
    r, angle = r[keep], angle[keep]
    basis = np.stack([r, r**2, r**3, r**4], 1)
    scale = basis.max(axis=0)
    k = np.linalg.lstsq(basis / scale, angle, rcond=None)[0] / scale
    return np.concatenate([[0.0], k])


def fit_error_px():
    """Largest error of the polynomial over the image, in pixels."""
    k = angle_polynomial()
    r = np.linspace(0, np.hypot(WIDTH, HEIGHT) / 2, 2001)
    u = np.tan(sum(c * r**i for i, c in enumerate(k)))
    return np.abs(FOCAL_PX * u * (1 + K1 * u**2 + K2 * u**4) - r).max()


if __name__ == "__main__":
    corner = np.hypot(WIDTH, HEIGHT) / 2
    print("fit error, px:", fit_error_px())
    u = np.tan(sum(c * corner**i for i, c in enumerate(angle_polynomial())))
    print("displacement at the corner, px:", corner - FOCAL_PX * u)
