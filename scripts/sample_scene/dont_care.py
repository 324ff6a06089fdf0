# SPDX-License-Identifier: BSD-3-Clause
"""Curves that images show but that are not part of the truth: cast shadows and occluding contours.

Runs inside Blender (ray casting).
"""

import numpy as np

import scene
import visibility
from geometry import Curve
from truth_curves import index_runs, resample, tangents

SIDE_STEP = 2e-4      # meters: how far beside an edge the light is traced
MIN_DROP = 0.003      # a shadow falls at least this far behind the edge that casts it
MAX_JUMP = 0.03       # longer steps between neighboring shadow points break the line
SUN_DISTANCE = 30.0


def shadow_curves(caster, solids, curves, light):
    """Borders of cast shadows, on whatever receives them, and the light's own contours on smooth bodies."""
    casters = [c.points for c in curves if c.kind == "edge"]
    contours = [resample(line) for solid in solids for line in solid.contours(**_seen_from(light))]
    result = []
    for points in casters + contours:
        result += _shadow_of(caster, points, light)
    for line in contours:
        origins, directions, distance = _rays(line, light)
        lit = caster.distances(origins, directions) > distance - visibility.OCCLUSION_TOLERANCE
        result += [line[a:b + 1] for a, b in index_runs(lit) if b - a >= 2]
    return [Curve(points, "shadow", light) for points in result]


def contour_curves(caster, solids, view_count):
    """Occluding contours of smooth bodies in each view, where the view sees them."""
    result = []
    for view in range(view_count):
        for solid in solids:
            for line in solid.contours(viewpoint=scene.camera_center(view)):
                points = resample(line)
                seen, _ = visibility.unoccluded(caster, points, view)
                result += [Curve(points[a:b + 1], "contour", solid.name)
                           for a, b in index_runs(visibility.majority(seen)) if b - a >= 2]
    return result


def _seen_from(light):
    if light in scene.SUNS:
        return dict(direction=scene.sun_direction(light))
    return dict(viewpoint=np.array(scene.LAMPS[light]["position"]))


def _rays(points, light):
    """Origins, unit directions and lengths of the light's rays to points."""
    if light in scene.SUNS:
        directions = np.broadcast_to(scene.sun_direction(light), points.shape)
        return points - SUN_DISTANCE * directions, directions, np.full(len(points), SUN_DISTANCE)
    offset = points - np.array(scene.LAMPS[light]["position"])
    distance = np.linalg.norm(offset, axis=1)
    return points - offset, offset / distance[:, None], distance


def _shadow_of(caster, points, light):
    """Light traced just beside an edge on both sides: where one side is stopped and the other passes, a shadow
    begins at the place the passing side reaches."""
    _, along, _ = _rays(points, light)
    side = np.cross(along, tangents(points))
    length = np.linalg.norm(side, axis=1, keepdims=True)
    side = side / np.maximum(length, 1e-9)
    hits, reach = [], []
    for sign in (1, -1):
        origins, directions, distance = _rays(points + sign * SIDE_STEP * side, light)
        hit = caster.distances(origins, directions)
        reach.append(hit - distance)
        hits.append(origins + np.where(np.isfinite(hit), hit, 0)[:, None] * directions)
    passes = [np.isfinite(r) & (r > MIN_DROP) for r in reach]
    stopped = [np.abs(r) < MIN_DROP for r in reach]
    ok0, ok1 = passes[0] & stopped[1], passes[1] & stopped[0]
    shadow = np.where(ok0[:, None], hits[0], hits[1])
    return _pieces(shadow, (ok0 | ok1) & (length[:, 0] > 0.05))


def _pieces(points, keep):
    """Runs of kept points without jumps."""
    jump = np.linalg.norm(np.diff(points, axis=0), axis=1) > MAX_JUMP
    result = []
    for first, last in index_runs(keep):
        cuts = [first] + [i + 1 for i in range(first, last) if jump[i]] + [last + 1]
        result += [points[a:b] for a, b in zip(cuts, cuts[1:]) if b - a >= 3]
    return result
