# SPDX-License-Identifier: BSD-3-Clause
"""Which parts of the true curves a set of images shows. Runs inside Blender (ray casting)."""

import cv2
import numpy as np

import cameras
import scene
from truth_curves import STEP, index_runs, tangents

MIN_VIEWS = 4
OCCLUSION_TOLERANCE = 0.0015   # meters along the ray
IMAGE_MARGIN_PX = 3.0
MIN_CONTRAST = 10.0            # gray levels of a sharp step
NOISE_FACTOR = 4.0             # the gradient must exceed its own noise by this factor
SIGMA_PX = 1.2                 # scale of the gradient
MAX_OFFSET_PX = 1.0            # the gradient's maximum may lie this far from the projected curve
MAX_ANGLE_DEG = 30.0           # between the gradient and the normal of the projected curve
SMOOTHING_SAMPLES = 5          # majority along the curve, per view
MAX_GAP, MIN_RUN = 0.010, 0.010  # meters: shorter gaps are closed, shorter runs dropped

# Peak gradient of a unit step seen through the pixel filter (about 0.5 px) and the gradient's own Gaussian.
STEP_RESPONSE = 1.0 / (np.sqrt(2 * np.pi) * np.hypot(SIGMA_PX, 0.5))
# Standard deviation of a Gaussian derivative's response to white noise of deviation 1.
NOISE_RESPONSE = 1.0 / (np.sqrt(8 * np.pi) * SIGMA_PX**2)


class GradientImage:
    """Gradient of the gray image, with the threshold above which it is an edge."""

    def __init__(self, path):
        gray = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        if gray is None:
            raise FileNotFoundError(path)
        gray = gray.astype(np.float32)
        self.noise = estimate_noise(gray)
        smooth = cv2.GaussianBlur(gray, (0, 0), SIGMA_PX, borderType=cv2.BORDER_REFLECT)
        self._gx = cv2.Sobel(smooth, cv2.CV_32F, 1, 0, ksize=1) / 2
        self._gy = cv2.Sobel(smooth, cv2.CV_32F, 0, 1, ksize=1) / 2
        self.threshold = max(MIN_CONTRAST * STEP_RESPONSE, NOISE_FACTOR * self.noise * NOISE_RESPONSE)

    def at(self, pixels):
        """Gradient at COLMAP pixel positions (any shape x 2)."""
        x = (pixels[..., 0] - 0.5).astype(np.float32)
        y = (pixels[..., 1] - 0.5).astype(np.float32)
        return np.stack([cv2.remap(g, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
                         for g in (self._gx, self._gy)], -1)

    def shows_edge(self, pixels, normals):
        """Whether there is an edge at the positions, across the given unit normals."""
        offsets = np.arange(-MAX_OFFSET_PX, MAX_OFFSET_PX + 0.01, 0.25)
        gradient = self.at(pixels[:, None] + offsets[None, :, None] * normals[:, None])
        across = np.abs(np.einsum("nki,ni->nk", gradient, normals))
        size = np.linalg.norm(gradient, axis=2)
        ok = (across > self.threshold) & (across > np.cos(np.radians(MAX_ANGLE_DEG)) * size)
        return ok.any(axis=1)


def estimate_noise(gray):
    """Robust standard deviation of pixel noise, from a second difference in both directions."""
    kernel = np.outer([1, -2, 1], [1, -2, 1]).astype(np.float32) / 6
    return float(1.4826 * np.median(np.abs(cv2.filter2D(gray, cv2.CV_32F, kernel))))


def unoccluded(caster, points, view, distorted=False):
    """(visible, pixels): in the image and not hidden."""
    pixels, depth = cameras.project(points, view, distorted)
    visible = cameras.in_image(pixels, depth, IMAGE_MARGIN_PX)
    if visible.any():
        visible[visible] = caster.sees(scene.camera_center(view), points[visible], OCCLUSION_TOLERANCE)
    return visible, pixels


def image_normals(points, view, distorted=False):
    """Unit normals of the projected curve at its samples."""
    tangent = tangents(points)
    a, _ = cameras.project(points - 5e-4 * tangent, view, distorted)
    b, _ = cameras.project(points + 5e-4 * tangent, view, distorted)
    direction = b - a
    direction /= np.maximum(np.linalg.norm(direction, axis=1, keepdims=True), 1e-12)
    return np.stack([-direction[:, 1], direction[:, 0]], 1)


def majority(flags):
    """Majority over neighboring samples; ends are extended."""
    half = SMOOTHING_SAMPLES // 2
    padded = np.pad(np.asarray(flags, float), half, mode="edge")
    return np.convolve(padded, np.ones(SMOOTHING_SAMPLES), "valid") > SMOOTHING_SAMPLES / 2


def occlusion_table(caster, curves, view_count, distorted=False):
    """Per curve: views x samples, whether the sample is in the image and not hidden."""
    return [np.stack([unoccluded(caster, curve.points, view, distorted)[0] for view in range(view_count)])
            for curve in curves]


def shown_counts(curves, occlusion, image_paths, distorted=False):
    """Per curve: in how many views each sample is unoccluded and seen as an edge."""
    images = [GradientImage(path) for path in image_paths]
    counts = []
    for curve, seen in zip(curves, occlusion):
        count = np.zeros(len(curve.points), int)
        for view, image in enumerate(images):
            if seen[view].any():
                pixels, _ = cameras.project(curve.points, view, distorted)
                normals = image_normals(curve.points, view, distorted)
                count += majority(seen[view] & image.shows_edge(pixels, normals))
        counts.append(count)
    return counts


def visible_samples(count):
    """Samples of a curve in the visible truth: enough views, short gaps closed, short runs dropped."""
    visible = count >= MIN_VIEWS
    for first, last in index_runs(~visible):
        inner = first > 0 and last < len(visible) - 1
        if inner and (last - first + 1) * STEP <= MAX_GAP:
            visible[first:last + 1] = True
    for first, last in index_runs(visible):
        if (last - first) * STEP < MIN_RUN:
            visible[first:last + 1] = False
    return visible
