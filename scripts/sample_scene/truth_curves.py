# SPDX-License-Identifier: BSD-3-Clause
"""Derives the curves of the scene from the edges of the solids. Needs numpy and scipy.

An edge buried in another solid, or enclosed between solids that touch, is not a curve of the scene. An edge
shared by two solids is kept once. The result includes the contact lines of solids that stand on or butt
against each other: in this scene these are always edges of one of the two.
"""

import numpy as np
from scipy.spatial import cKDTree

from geometry import Curve

STEP = 0.0025          # sampling along a curve, meters: about half a pixel footprint
SURFACE_MARGIN = 1e-5  # a point less deep than this counts as on the surface
PROBE = 4e-4           # free space is looked for at this distance around a curve point


def resample(points, step=STEP):
    """Points at a uniform arc length of at most `step`; both ends are kept."""
    points = np.asarray(points, float)
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    count = max(2, int(np.ceil(arc[-1] / step)) + 1)
    where = np.linspace(0.0, arc[-1], count)
    return np.stack([np.interp(where, arc, points[:, axis]) for axis in range(3)], 1)


def tangents(points):
    """Unit tangents of a sampled curve."""
    if np.allclose(points[0], points[-1]):
        step = np.roll(points[:-1], -1, axis=0) - np.roll(points[:-1], 1, axis=0)
        step = np.concatenate([step, step[:1]])
    else:
        step = np.gradient(points, axis=0)
    return step / np.linalg.norm(step, axis=1, keepdims=True)


def _probe_directions():
    grid = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z], float)
    # Turned, so that no direction runs along a face of the scene.
    angle = np.radians(11.3)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    tilt = np.array([[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]])
    return grid / np.linalg.norm(grid, axis=1, keepdims=True) @ turn @ tilt


PROBES = _probe_directions()


class FreeSpace:
    """Tells whether points on edges border on free space."""

    def __init__(self, solids):
        self._solids = solids

    def exposed(self, points, owner):
        """Which points are not inside another solid and have free space around them."""
        exposed = ~self._inside(points, SURFACE_MARGIN, skip=owner)
        near = (points[exposed][:, None] + PROBE * PROBES).reshape(-1, 3)
        free = ~self._inside(near, 0.0) & (near[:, 2] > 0)
        exposed[exposed] = free.reshape(-1, len(PROBES)).any(axis=1)
        return exposed

    def _inside(self, points, margin, skip=None):
        inside = np.zeros(len(points), bool)
        for solid in self._solids:
            if solid.name != skip:
                inside |= solid.contains(points, margin)
        return inside


def scene_curves(solids):
    """All true curves, resampled; ends made by trimming are exact to a few micrometers."""
    space = FreeSpace(solids)
    accepted = []
    for curve in (c for solid in solids for c in solid.curves()):
        points = resample(curve.points)
        for part in _runs(points, space.exposed(points, curve.owner),
                          lambda p, owner=curve.owner: space.exposed(p[None], owner)[0]):
            accepted.append(Curve(part, curve.kind, curve.owner))
    return _without_duplicates(accepted)


def _runs(points, keep, test):
    """Consecutive kept samples; each cut is moved to the exact place by bisection."""
    parts = []
    for first, last in index_runs(keep):
        part = [points[first:last + 1]]
        if first > 0:
            part.insert(0, _bisect(points[first], points[first - 1], test)[None])
        if last + 1 < len(points):
            part.append(_bisect(points[last], points[last + 1], test)[None])
        part = np.concatenate(part)
        if np.linalg.norm(np.diff(part, axis=0), axis=1).sum() > STEP:
            parts.append(resample(part))
    return _join_around(parts, points)


def _join_around(parts, points):
    """The first and the last part of a closed curve are one."""
    closed = np.allclose(points[0], points[-1])
    if closed and len(parts) > 1 and np.allclose(parts[0][0], points[0]) and np.allclose(parts[-1][-1], points[0]):
        parts = [np.concatenate([parts[-1], parts[0][1:]])] + parts[1:-1]
    return parts


def index_runs(keep):
    """(first, last) of each run of True."""
    padded = np.concatenate([[0], np.asarray(keep, int), [0]])
    change = np.diff(padded)
    return list(zip(np.nonzero(change == 1)[0], np.nonzero(change == -1)[0] - 1))


def _bisect(good, bad, test):
    for _ in range(12):
        middle = (good + bad) / 2
        if test(middle):
            good = middle
        else:
            bad = middle
    return good


def _without_duplicates(curves):
    """Drops what runs along an earlier curve."""
    result, points, directions = [], np.zeros((0, 3)), np.zeros((0, 3))
    for curve in curves:
        tangent = tangents(curve.points)
        keep = np.ones(len(curve.points), bool)
        if len(points):
            tree = cKDTree(points)
            for i, neighbors in enumerate(tree.query_ball_point(curve.points, 0.6 * STEP + 3e-4)):
                keep[i] = not _any_parallel(curve.points[i], tangent[i], points[neighbors], directions[neighbors])
        # A lone sample at a shared corner does not break a curve.
        for first, last in index_runs(~keep):
            if last - first < 2:
                keep[first:last + 1] = True
        for first, last in index_runs(keep):
            if last - first >= 2:
                result.append(Curve(curve.points[first:last + 1], curve.kind, curve.owner))
        points, directions = np.concatenate([points, curve.points]), np.concatenate([directions, tangent])
    return result


def _any_parallel(point, tangent, others, directions):
    offset = others - point
    across = np.linalg.norm(offset - (offset @ tangent)[:, None] * tangent, axis=1)
    return bool(np.any((across < 3e-4) & (np.abs(directions @ tangent) > 0.996)))


def simplified(points, tolerance=2e-5):
    """The same polyline without the vertices a straight line explains to `tolerance` (meters; 0.004 px here)."""
    keep = np.zeros(len(points), bool)
    keep[[0, -1]] = True
    stack = [(0, len(points) - 1)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        chord = points[b] - points[a]
        length = np.linalg.norm(chord)
        offset = points[a + 1:b] - points[a]
        if length > 1e-9:
            offset = offset - np.outer(offset @ chord / length**2, chord)
        distance = np.linalg.norm(offset, axis=1)
        worst = int(np.argmax(distance))
        if distance[worst] > tolerance:
            keep[a + 1 + worst] = True
            stack += [(a, a + 1 + worst), (a + 1 + worst, b)]
    return points[keep]
