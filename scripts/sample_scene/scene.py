# SPDX-License-Identifier: BSD-3-Clause
"""The sample scene: its solids, lights and cameras. Needs numpy only; used by all other scripts."""

import numpy as np

from geometry import (Prism, Pyramid, arch, circle, painted_band, painted_disc, painted_rectangle,
                      polygon, rectangle, standing, upright, wave)

WIDTH, HEIGHT = 640, 480
FOCAL_PX = 640.0
# COLMAP's convention: the center of the top-left pixel is (0.5, 0.5). Off center on purpose.
PRINCIPAL_POINT = (316.0, 244.0)
VIEW_COUNT = 24
# A second path, never committed: to measure how time and memory grow with the number of views.
LONG_VIEW_COUNT = 100
LIGHTS = ("day", "evening", "lamp")

PLINTH_TOP = 0.10
# Where a drawing is compared with the truth: from just above the textured ground.
REGION_OF_INTEREST = ((-1.25, -0.95, 0.04), (1.25, 0.95, 1.05))

LIGHT_GRAY = (0.50, 0.49, 0.46)
DARK = (0.07, 0.07, 0.08)
WHITE = (0.82, 0.82, 0.80)
RED = (0.48, 0.09, 0.06)
BLUE = (0.06, 0.14, 0.36)
GREEN = (0.09, 0.26, 0.12)
OCHRE = (0.68, 0.43, 0.10)
WOOD = (0.72, 0.55, 0.33)
VIOLET = (0.22, 0.10, 0.30)


def box(name, size, pose, color, paints=()):
    """A box standing on its pose's origin."""
    return Prism(name, rectangle(size[0], size[1]), size[2], pose, color, paints)


def solids():
    """Every solid of the scene except the ground."""
    return _base() + _crate() + _table() + _round_things() + _gate_and_board() + _beams() + _clutter()


def _base():
    return [box("plinth", (2.3, 1.7, PLINTH_TOP), upright(0, 0, 0), LIGHT_GRAY)]


def _crate():
    turn, x, y, h = 17.0, -0.68, -0.36, 0.34
    top = PLINTH_TOP + h
    crate = box("crate", (0.44, 0.34, h), upright(x, y, PLINTH_TOP, turn), RED, [
        painted_disc(WHITE, (0.0, -0.17, 0.18), 1, 0.10),
        painted_rectangle(OCHRE, 0, 0.22, (-0.09, 0.10), (0.08, h)),
        painted_rectangle(OCHRE, 1, 0.17, (-0.12, 0.08), (0.14, 0.24)),
    ])
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    handle = Prism("handle", arch(0.075, 0.05, 0.093), 0.02,
                   standing(x - 0.01 * s, y + 0.01 * c, top, turn), DARK)
    return [crate, handle]


def _table():
    x, y, turn, height, thick, leg = 0.28, 0.40, -8.0, 0.36, 0.03, 0.02
    under, top = PLINTH_TOP + height, PLINTH_TOP + height + thick
    parts = [box("table top", (0.62, 0.42, thick), upright(x, y, under, turn), WOOD)]
    pose = upright(x, y, PLINTH_TOP, turn)
    for number, (dx, dy) in enumerate([(-1, -1), (1, -1), (1, 1), (-1, 1)]):
        foot = pose.to_world([(dx * 0.28, dy * 0.18, 0)])[0]
        parts.append(box(f"leg {number}", (leg, leg, height), upright(*foot, turn), DARK))
    parts.append(Prism("mug", circle(0.06), 0.12, upright(0.12, 0.36, top), BLUE,
                       [painted_band(WHITE, circle(0.06) + circle(0.048), 0.04, 0.075)], hole=circle(0.048)))
    parts.append(Pyramid("pyramid", [(-0.09, -0.09), (0.09, -0.09), (0.09, 0.09), (-0.09, 0.09)],
                         (0, 0, 0.17), upright(0.41, 0.40, top, 22), GREEN))
    return parts


def _round_things():
    tube = Prism("tube", circle(0.17), 0.30, upright(0.78, -0.47, PLINTH_TOP), BLUE,
                 [painted_band(OCHRE, circle(0.17) + circle(0.135), 0.11, 0.19)], hole=circle(0.135))
    drum = Prism("drum", circle(0.15), 0.20, upright(0.20, -0.14, PLINTH_TOP), OCHRE,
                 [painted_disc(VIOLET, (0.03, 0.0, 0.20), 2, 0.075)])
    return [tube, drum]


def _gate_and_board():
    gate = Prism("gate", arch(0.20, 0.26, 0.30), 0.14, standing(-0.52, 0.49, PLINTH_TOP, -16), GREEN)
    board = box("board", (0.04, 0.66, 0.46), upright(0.95, 0.30, PLINTH_TOP), WHITE, [
        painted_rectangle(RED, 0, 0.02, (-0.18, 0.27), (0.14, 0.46)),
        painted_rectangle(BLUE, 0, 0.02, (-0.33, 0.06), (0.33, 0.14)),
    ])
    shelf = box("shelf", (0.17, 0.34, 0.03), upright(0.845, 0.28, PLINTH_TOP + 0.22), VIOLET)
    fin = box("fin", (0.14, 0.03, 0.20), upright(1.04, 0.34, PLINTH_TOP), GREEN)
    waves = Prism("wave", wave(0.46, 0.16, 0.045, 1.5), 0.05, standing(-0.10, 0.10, PLINTH_TOP, 72), VIOLET)
    return [gate, board, shelf, fin, waves]


def _beams():
    beam = box("beam", (0.86, 0.07, 0.08), upright(0.04, -0.74, PLINTH_TOP), WOOD)
    bar = box("bar", (0.05, 0.24, 0.05), upright(-0.20, -0.585, PLINTH_TOP), BLUE)
    flush = box("flush bar", (0.06, 0.16, 0.08), upright(0.06, -0.625, PLINTH_TOP), RED)
    # A ramp: right-angled outline, extruded horizontally; its slope carries a painted stripe.
    wedge = Prism("wedge", polygon((0, 0), (0.34, 0), (0, 0.20)), 0.20,
                  standing(0.30, -0.42, PLINTH_TOP, 10), WHITE,
                  [painted_rectangle(RED, 2, 0.20, (0.03, 0.03), (0.12, 0.10))])
    return [beam, bar, flush, wedge]


def _clutter():
    bricks = [
        box("brick 0", (0.20, 0.10, 0.07), upright(-0.28, -0.22, PLINTH_TOP, 40), WHITE),
        box("brick 1", (0.12, 0.08, 0.06), upright(-0.27, -0.22, PLINTH_TOP + 0.07, -15), DARK),
        box("brick 2", (0.10, 0.10, 0.10), upright(0.52, -0.10, PLINTH_TOP, 30), BLUE),
        box("brick 3", (0.14, 0.09, 0.05), upright(1.00, -0.18, PLINTH_TOP, 65), RED),
        Prism("puck", circle(0.06), 0.05, upright(-0.98, -0.02, PLINTH_TOP), WOOD),
    ]
    posts = [box(f"post {i}", (0.016, 0.016, 0.30), upright(-1.05, y, PLINTH_TOP), DARK)
             for i, y in enumerate((0.12, 0.42, 0.72))]
    rail = box("rail", (0.022, 0.66, 0.022), upright(-1.05, 0.42, PLINTH_TOP + 0.30), OCHRE)
    return bricks + posts + [rail]


# ----------------------------------------------------------------------------------------------
# Cameras


def view_name(index):
    return f"view_{index:02d}.jpg"


def camera_pose(index):
    """(R, t) of cam_from_world; x right, y down, z forward."""
    return _pose_at(camera_center(index), np.random.default_rng(100 + index))


def camera_center(index):
    """A full circle of 24 steps; heights cycle through low, middle, high, so neighbors differ."""
    return _center_at(index / VIEW_COUNT, index, np.random.default_rng(index))


def long_camera_pose(index):
    """As camera_pose, on the long path."""
    return _pose_at(long_camera_center(index), np.random.default_rng(2000 + index))


def long_camera_center(index):
    """The same circle in LONG_VIEW_COUNT steps. Every second and every fourth view make a path of the same kind."""
    step = index // 4 + (0, 3, 2, 0)[index % 4]
    return _center_at(index / LONG_VIEW_COUNT, step, np.random.default_rng(1000 + index))


def _center_at(turn, step, rng):
    """Place on the circle: share of the full turn, and which of the heights."""
    azimuth = np.radians(360.0 * turn + rng.uniform(-4, 4))
    elevation = np.radians((20, 37, 28, 50)[step % 4] + rng.uniform(-4, 4))
    distance = 3.15 + rng.uniform(-0.3, 0.4)
    return distance * np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation),
                                np.sin(elevation)]) + (0, 0, 0.15)


def _pose_at(center, rng):
    target = np.array([0.0, 0.0, 0.22]) + rng.uniform(-1, 1, 3) * (0.12, 0.12, 0.05)
    forward = (target - center) / np.linalg.norm(target - center)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    roll = np.radians(rng.uniform(-4, 4))
    down = np.cross(forward, right)
    right, down = np.cos(roll) * right + np.sin(roll) * down, np.cos(roll) * down - np.sin(roll) * right
    rotation = np.stack([right, down, forward])
    return rotation, -rotation @ center


# ----------------------------------------------------------------------------------------------
# Lights. A sun has the direction its light travels; a lamp has a position.

SUNS = {"day": dict(elevation=48.0, azimuth=-62.0, strength=3.2, angle=1.2, color=(1.0, 0.97, 0.92)),
        "evening": dict(elevation=24.0, azimuth=152.0, strength=2.6, angle=1.2, color=(1.0, 0.72, 0.45))}
LAMPS = {"lamp": dict(position=(0.55, 0.05, 2.1), power=75.0, radius=0.04, color=(1.0, 0.85, 0.62))}
# Fill light from all around: mean strength, color, and how much brighter it is towards `bright`.
SKIES = {"day": dict(strength=0.28, color=(0.85, 0.93, 1.0), bright=(0.75, 0.45, 0.5), contrast=0.75),
         "evening": dict(strength=0.26, color=(0.72, 0.82, 1.0), bright=(0.3, -0.85, 0.4), contrast=0.75),
         "lamp": dict(strength=0.16, color=(0.75, 0.85, 1.0), bright=(-0.8, -0.2, 0.5), contrast=0.75)}


def sun_direction(light):
    """Unit vector along which the sun's light travels."""
    e, a = np.radians(SUNS[light]["elevation"]), np.radians(SUNS[light]["azimuth"])
    return -np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
