# SPDX-License-Identifier: BSD-3-Clause
"""Junctions of the visible truth: points where at least three visible curve arms meet. numpy and scipy."""

import numpy as np
from scipy.spatial import cKDTree

from truth_curves import STEP

SAME_POINT = 0.001      # meters: curves this close to a point pass through it
ARM_FROM, ARM_TO = 0.004, 0.025   # meters from the junction: where an arm must be visible
ARM_DIRECTION_AT = 0.010
MIN_ARM_SHARE = 0.5
SAME_DIRECTION_DEG = 12.0
STRAIGHT_DEG = 165.0


def find_junctions(curves, visible):
    """List of dicts: position, degree, kind ("corner" or "t" or "crossing"), degree of all true arms."""
    samples = np.concatenate([c.points for c in curves])
    owner = np.concatenate([np.full(len(c.points), i) for i, c in enumerate(curves)])
    tree = cKDTree(samples)
    result = []
    for point in _clusters(_candidates(curves, samples, owner, tree)):
        near = np.unique(owner[tree.query_ball_point(point, 2 * STEP)])
        arms = [arm for i in near for arm in _arms(point, curves[i].points, visible[i])]
        arms = _distinct(arms)
        shown = [direction for direction, share in arms if share >= MIN_ARM_SHARE]
        if len(shown) >= 3:
            result.append(dict(position=[round(float(v), 7) for v in point], degree=len(shown),
                               kind=_kind(shown), true_degree=len(arms)))
    return sorted(result, key=lambda j: j["position"])


def _candidates(curves, samples, owner, tree):
    """Ends of curves, and places where two curves cross."""
    ends = [c.points[k] for c in curves for k in (0, -1)]
    crossings = []
    for i, j in tree.query_pairs(1.5 * STEP, output_type="ndarray"):
        if owner[i] != owner[j]:
            point = _crossing(samples, owner, i, j)
            if point is not None:
                crossings.append(point)
    return np.array(ends + crossings)


def _crossing(samples, owner, i, j):
    """Where the lines of two curves through samples i and j meet, if they do."""
    a, b = _direction(samples, owner, i), _direction(samples, owner, j)
    sine = np.linalg.norm(np.cross(a, b))
    if sine < np.sin(np.radians(SAME_DIRECTION_DEG)):
        return None
    offset = samples[j] - samples[i]
    normal = np.cross(a, b) / sine
    if abs(offset @ normal) > 2e-4:
        return None
    s = np.cross(offset, b) @ normal / sine
    t = np.cross(offset, a) @ normal / sine
    if max(abs(s), abs(t)) > STEP:
        return None
    return samples[i] + s * a


def _direction(samples, owner, i):
    j = i + 1 if i + 1 < len(owner) and owner[i + 1] == owner[i] else i - 1
    d = samples[j] - samples[i]
    return d / np.linalg.norm(d)


def _clusters(points):
    """One point per group of coinciding candidates."""
    left, result = np.ones(len(points), bool), []
    tree = cKDTree(points)
    for i in range(len(points)):
        if left[i]:
            group = [k for k in tree.query_ball_point(points[i], 2 * SAME_POINT) if left[k]]
            left[group] = False
            result.append(np.median(points[group], axis=0))
    return result


def _arms(point, curve, visible):
    """(direction, visible share) of the one or two arms of a curve that passes through the point."""
    distance = np.linalg.norm(curve - point, axis=1)
    k = int(np.argmin(distance))
    if _distance_to_curve(point, curve, k) > SAME_POINT:
        return []
    # A closed curve that starts here has its two arms at its two ends.
    if np.allclose(curve[0], curve[-1]):
        curve, visible = np.roll(curve[:-1], len(curve) // 2 - k, axis=0), np.roll(visible[:-1], len(curve) // 2 - k)
        k = len(curve) // 2
    arms = []
    for part, flags in ((curve[k:], visible[k:]), (curve[k::-1], visible[k::-1])):
        reach = np.linalg.norm(part - point, axis=1)
        stop = int(np.argmax(reach > ARM_TO)) if (reach > ARM_TO).any() else len(reach)
        inside = np.arange(len(reach)) < stop
        tested = inside & (reach >= ARM_FROM)
        if tested.sum() >= 3:
            at = int(np.argmin(np.where(inside, np.abs(reach - ARM_DIRECTION_AT), np.inf)))
            direction = (part[at] - point) / reach[at]
            arms.append((direction, float(flags[tested].mean())))
    return arms


def _distance_to_curve(point, curve, k):
    best = np.linalg.norm(curve[k] - point)
    for j in (k - 1, k + 1):
        if 0 <= j < len(curve):
            step = curve[j] - curve[k]
            t = np.clip((point - curve[k]) @ step / (step @ step), 0, 1)
            best = min(best, np.linalg.norm(curve[k] + t * step - point))
    return best


def _distinct(arms):
    """Merges arms that leave in the same direction; the better visible one counts."""
    result = []
    for direction, share in sorted(arms, key=lambda arm: -arm[1]):
        if all(direction @ other < np.cos(np.radians(SAME_DIRECTION_DEG)) for other, _ in result):
            result.append((direction, share))
    return result


def _kind(directions):
    straight = sum(1 for i, a in enumerate(directions) for b in directions[:i]
                   if a @ b < np.cos(np.radians(STRAIGHT_DEG)))
    if straight == 0:
        return "corner"
    return "crossing" if straight >= 2 else "t"
