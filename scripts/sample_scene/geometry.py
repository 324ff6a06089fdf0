# SPDX-License-Identifier: BSD-3-Clause
"""Solids with exactly known edges and paint, from which the sample scene is made.

A solid is a prism (any planar outline, extruded) or a pyramid. It provides its mesh (for rendering and
ray casting), its sharp edges and the borders of its paint (the truth), whether a point lies inside
it (to remove edges buried in another solid), and where its smooth sides turn away from a viewpoint
(occluding contours, which are not true curves). Lengths are meters, the world's z axis points up.
This file needs numpy only.
"""

from dataclasses import dataclass, field

import numpy as np

SEGMENTS_PER_TURN = 256


@dataclass
class Curve:
    """A polyline in the world. `kind` is "edge" (shape) or "paint" (reflectance)."""

    points: np.ndarray
    kind: str
    owner: str


@dataclass
class Paint:
    """A region of a solid (local coordinates) with its own color, and the region's exact border.

    The region is a ball (`center`, `radius`) or an axis-aligned box (`low`, `high`, may be infinite).
    """

    color: tuple
    border: list
    center: tuple = None
    radius: float = 0.0
    low: tuple = None
    high: tuple = None


@dataclass
class Pose:
    """world_from_local: rotation matrix and translation."""

    rotation: np.ndarray = field(default_factory=lambda: np.eye(3))
    translation: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def to_world(self, points):
        return np.asarray(points, float) @ self.rotation.T + self.translation

    def to_local(self, points):
        return (np.asarray(points, float) - self.translation) @ self.rotation


def upright(x, y, z, turn_deg=0.0):
    """Pose of a solid whose outline lies in the ground plane and is extruded upwards."""
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    return Pose(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.array([x, y, z], float))


def standing(x, y, z, turn_deg=0.0):
    """Pose of a solid whose outline stands upright (local y is up) and is extruded horizontally."""
    stand = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], float)
    pose = upright(x, y, z, turn_deg)
    return Pose(pose.rotation @ stand, pose.translation)


def arc(cx, cy, radius, start_deg, end_deg):
    """Points of a circular arc, both ends included."""
    count = max(2, int(round(abs(end_deg - start_deg) / 360 * SEGMENTS_PER_TURN)) + 1)
    angle = np.radians(np.linspace(start_deg, end_deg, count))
    return np.stack([cx + radius * np.cos(angle), cy + radius * np.sin(angle)], 1)


def circle_in_space(center, normal_axis, radius):
    """A closed circle around a coordinate axis (0, 1 or 2), local coordinates."""
    flat = arc(0, 0, radius, 0, 360)
    points = np.insert(flat, normal_axis, 0.0, axis=1)
    points[-1] = points[0]
    return points + np.asarray(center, float)


# ----------------------------------------------------------------------------------------------
# Outlines: lists of pieces; a piece is a smooth polyline, consecutive pieces meet at a corner.


def polygon(*corners):
    """Outline with straight sides; corners counter-clockwise."""
    corners = [np.asarray(c, float) for c in corners]
    return [np.stack([a, b]) for a, b in zip(corners, corners[1:] + corners[:1])]


def rectangle(size_x, size_y):
    """Rectangle centerd at the origin."""
    x, y = size_x / 2, size_y / 2
    return polygon((-x, -y), (x, -y), (x, y), (-x, y))


def circle(radius):
    return [arc(0, 0, radius, 0, 360)]


def arch(half_span, leg_height, outer_radius):
    """A gate: two legs joined by a half ring; `half_span` is the inner radius."""
    outer = np.concatenate(
        [[(outer_radius, 0)], arc(0, leg_height, outer_radius, 0, 180), [(-outer_radius, 0)]])
    inner = np.concatenate(
        [[(-half_span, 0)], arc(0, leg_height, half_span, 180, 0), [(half_span, 0)]])
    left = np.array([(-outer_radius, 0), (-half_span, 0)], float)
    right = np.array([(half_span, 0), (outer_radius, 0)], float)
    return [outer, left, inner, right]


def wave(length, height, amplitude, periods):
    """A board whose upper border is a sine curve."""
    x = np.linspace(length / 2, -length / 2, 257)
    top = np.stack([x, height + amplitude * np.sin(2 * np.pi * periods * x / length)], 1)
    a, b = np.array([-length / 2, 0.0]), np.array([length / 2, 0.0])
    return [np.stack([a, b]), np.stack([b, top[0]]), top, np.stack([top[-1], a])]


# ----------------------------------------------------------------------------------------------


class Prism:
    """An outline in the local x-y plane, extruded from z = 0 to z = height; one round hole allowed."""

    def __init__(self, name, outline, height, pose, color, paints=(), hole=None):
        self.name, self.outline, self.height = name, outline, height
        self.pose, self.color, self.paints, self.hole = pose, color, list(paints), hole

    def _loops(self):
        return [self.outline] + ([self.hole] if self.hole else [])

    def mesh(self):
        """Vertices (local) and faces; every face looks outwards."""
        vertices, faces, rings = [], [], []
        for number, pieces in enumerate(self._loops()):
            flat = _closed_loop(pieces)
            n, first = len(flat), sum(len(v) for v in vertices)
            vertices.append(np.column_stack([flat, np.zeros(n)]))
            vertices.append(np.column_stack([flat, np.full(n, self.height)]))
            low, high = np.arange(first, first + n), np.arange(first + n, first + 2 * n)
            rings.append((low, high))
            for i in range(n):
                j = (i + 1) % n
                side = [low[i], low[j], high[j], high[i]]
                faces.append(side if number == 0 else side[::-1])
        if self.hole:
            faces += _caps_between(rings[0], rings[1])
        else:
            low, high = rings[0]
            faces += [list(low[::-1]), list(high)]
        return np.concatenate(vertices), [[int(i) for i in face] for face in faces]

    def curves(self):
        """Sharp edges and paint borders, in the world."""
        result = []
        for pieces in self._loops():
            closed = len(pieces) == 1
            for piece in pieces:
                for z in (0.0, self.height):
                    result.append(self._curve(np.column_stack([piece, np.full(len(piece), z)]), "edge"))
                if not closed:
                    x, y = piece[0]
                    result.append(self._curve([(x, y, 0.0), (x, y, self.height)], "edge"))
        for paint in self.paints:
            result += [self._curve(points, "paint") for points in paint.border]
        return result

    def _curve(self, points, kind):
        return Curve(self.pose.to_world(points), kind, self.name)

    def contains(self, points, margin):
        """Which world points lie inside by more than `margin` (negative margin: grown solid)."""
        local = self.pose.to_local(points)
        inside = (local[:, 2] > margin) & (local[:, 2] < self.height - margin)
        if inside.any():
            flat = local[inside, :2]
            depth = _signed_depth(_closed_loop(self.outline), flat)
            if self.hole:
                depth = np.minimum(depth, -_signed_depth(_closed_loop(self.hole), flat))
            inside[inside] = depth > margin
        return inside

    def contours(self, viewpoint=None, direction=None):
        """Straight lines where smooth sides turn away from a viewpoint or a light direction (world)."""
        result = []
        for piece in self.outline:  # a hole's wall is concave: it never hides itself
            if len(piece) > 2:
                result += self._contours_of_piece(piece, viewpoint, direction)
        return result

    def _contours_of_piece(self, piece, viewpoint, direction):
        middle = (piece[1:] + piece[:-1]) / 2
        step = piece[1:] - piece[:-1]
        normal = np.stack([step[:, 1], -step[:, 0]], 1)
        if viewpoint is not None:
            towards = self.pose.to_local(viewpoint[None])[0, :2] - middle
        else:
            towards = np.broadcast_to((-direction @ self.pose.rotation)[:2], middle.shape)
        facing = np.einsum("ij,ij->i", normal, towards) > 0
        turns = [i + 1 for i in np.nonzero(facing[1:] != facing[:-1])[0]]
        if np.allclose(piece[0], piece[-1]) and facing[0] != facing[-1]:
            turns.append(0)
        lines = []
        for i in turns:
            x, y = piece[i]
            lines.append(self.pose.to_world([(x, y, 0.0), (x, y, self.height)]))
        return lines


class Pyramid:
    """A polygon in the local x-y plane joined to an apex."""

    def __init__(self, name, corners, apex, pose, color):
        self.name, self.pose, self.color, self.paints = name, pose, color, []
        self.corners = [np.array([x, y, 0.0]) for x, y in corners]
        self.apex = np.asarray(apex, float)

    def mesh(self):
        n = len(self.corners)
        faces = [[i, (i + 1) % n, n] for i in range(n)] + [list(range(n))[::-1]]
        return np.array(self.corners + [self.apex]), faces

    def curves(self):
        pairs = list(zip(self.corners, self.corners[1:] + self.corners[:1]))
        pairs += [(corner, self.apex) for corner in self.corners]
        return [Curve(self.pose.to_world(pair), "edge", self.name) for pair in pairs]

    def contains(self, points, margin):
        local = self.pose.to_local(points)
        inside = np.ones(len(local), bool)
        vertices, faces = self.mesh()
        for a, b, c in (vertices[face[:3]] for face in faces):
            normal = np.cross(b - a, c - a)
            inside &= (local - a) @ (normal / np.linalg.norm(normal)) < -margin
        return inside

    def contours(self, viewpoint=None, direction=None):
        return []


def _closed_loop(pieces):
    """The outline's vertices in order, each once."""
    return np.concatenate([piece[:-1] for piece in pieces])


def _caps_between(outer, inner):
    """Bottom and top of a prism with a hole, as quadrilaterals between two loops of equal length."""
    n, faces = len(outer[0]), []
    for i in range(n):
        j = (i + 1) % n
        faces.append([outer[1][i], outer[1][j], inner[1][j], inner[1][i]])
        faces.append([outer[0][j], outer[0][i], inner[0][i], inner[0][j]])
    return faces


def _signed_depth(loop, points):
    """Distance to a simple polygon's border, positive inside."""
    a, b = loop, np.roll(loop, -1, axis=0)
    distance = np.full(len(points), np.inf)
    inside = np.zeros(len(points), bool)
    x, y = points.T
    for (ax, ay), (bx, by) in zip(a, b):
        dx, dy = bx - ax, by - ay
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
        distance = np.minimum(distance, np.hypot(x - ax - t * dx, y - ay - t * dy))
        crosses = (ay > y) != (by > y)
        if ay != by:
            inside ^= crosses & (x < ax + (y - ay) / (by - ay) * dx)
    return np.where(inside, distance, -distance)


# ----------------------------------------------------------------------------------------------
# Paint


def painted_disc(color, center, normal_axis, radius):
    """A disc on a plane face through `center`, perpendicular to a local axis."""
    return Paint(color, [circle_in_space(center, normal_axis, radius)], center=center, radius=radius)


def painted_band(color, pieces, low, high):
    """A stripe around a prism (inside its hole too), from local z = low to high; pieces of all its loops."""
    border = [np.column_stack([piece, np.full(len(piece), z)]) for z in (low, high) for piece in pieces]
    infinity = np.inf
    return Paint(color, border, low=(-infinity, -infinity, low), high=(infinity, infinity, high))


def painted_rectangle(color, axis, value, low, high):
    """A rectangle on the face `axis` = `value`; low and high are its corners in the two other axes."""
    (u0, v0), (u1, v1) = low, high
    corners = [np.insert(np.array(c, float), axis, value) for c in ((u0, v0), (u1, v0), (u1, v1), (u0, v1))]
    border = [np.stack(pair) for pair in zip(corners, corners[1:] + corners[:1])]
    eps = 1e-4
    return Paint(color, border,
                 low=tuple(np.insert(np.array(low, float), axis, value - eps)),
                 high=tuple(np.insert(np.array(high, float), axis, value + eps)))
