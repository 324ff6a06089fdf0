# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with right and with wrong cameras, for false_confidence.py. Poses: camera = rotation (world - center)."""

from dataclasses import dataclass, replace
from typing import Callable

import cv2
import numpy as np

from camera_poses import read_cameras, read_images

FLAT_SIZE = (480, 360)  # of rendered pictures, px
FOCAL = 500.0
NUM_FLAT = 12


@dataclass
class PosedPicture:
    picture: np.ndarray
    camera_model: str
    parameters: list
    rotation: np.ndarray
    center: np.ndarray


@dataclass
class Scene:
    name: str
    make: Callable
    base: str = ""  # the same views with right cameras, if cameras were moved
    is_right: bool = False


# Photographs and made sets.


def read_views(images, sparse):
    """In the order of the names."""
    cameras, views = read_cameras(sparse / "cameras.bin"), []
    for name, (rotation, translation, camera) in sorted(read_images(sparse / "images.bin").items()):
        model, _, parameters = cameras[camera]
        views.append(PosedPicture(cv2.imread(str(images / name)), model, parameters, rotation, -rotation.T @ translation))
    return views


# Flat things.


def art(rng, size=1600):
    picture = np.full((size, size, 3), 235, np.uint8)
    for _ in range(45):
        color, corner = tuple(int(c) for c in rng.integers(0, 255, 3)), rng.integers(60, size - 60, 2)
        if rng.random() < 0.5:
            cv2.rectangle(picture, tuple(map(int, corner)), tuple(map(int, np.minimum(corner + rng.integers(60, 320, 2), size - 40))), color, -1)
        else:
            cv2.fillPoly(picture, [np.clip(corner + rng.integers(-180, 180, (4, 2)), 30, size - 30).astype(np.int32)], color)
    return picture


def stripes(_, size=1600):
    picture = np.full((size, size, 3), 235, np.uint8)
    for begin in range(0, size, 80):
        picture[:, begin:begin + 40] = 30
    return picture


def checkers(_, size=1600):
    picture = np.full((size, size, 3), 235, np.uint8)
    picture[(np.add.outer(np.arange(size) // 80, np.arange(size) // 80) % 2) == 0] = 30
    return picture


def windows(_, size=1600):
    picture = np.full((size, size, 3), 200, np.uint8)
    for y in range(60, size - 100, 160):
        for x in range(40, size - 60, 100):
            cv2.rectangle(picture, (x, y), (x + 50, y + 90), (60, 50, 40), -1)
    return picture


def looking_at(center, target=(0, 0, 0)):
    z = np.array(target, float) - center
    z /= np.linalg.norm(z)
    x = np.cross((0, -1, 0), z)
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def flat_view(texture, center, rotation, rng, focal=FOCAL, width=2.0):
    """The texture is `width` wide in the plane z = 0."""
    size, (w, h) = texture.shape[0], FLAT_SIZE
    in_plane = np.array([[width / size, 0, -width / 2], [0, -width / size, width / 2], [0, 0, 1]])
    camera = np.array([[2 * focal, 0, w], [0, 2 * focal, h], [0, 0, 1]])
    to_picture = camera @ np.column_stack([rotation[:, 0], rotation[:, 1], -rotation @ center]) @ in_plane
    large = cv2.warpPerspective(texture, to_picture, (2 * w, 2 * h), flags=cv2.INTER_AREA, borderValue=(200, 190, 180))
    noisy = cv2.resize(large, (w, h), interpolation=cv2.INTER_AREA) + 1.5 * rng.standard_normal((h, w, 3))
    return PosedPicture(np.clip(noisy, 0, 255).astype(np.uint8), "PINHOLE", [focal, focal, w / 2, h / 2], rotation, np.array(center, float))


def on_arc(rng, texture, radius=3.0, focal=FOCAL, span=70):
    angles = np.radians(np.linspace(-span / 2, span / 2, NUM_FLAT))
    centers = [radius * np.array([np.sin(a), np.sin(1.7 * i) / 6, np.cos(a)]) for i, a in enumerate(angles)]
    return [flat_view(texture, c, looking_at(c), rng, focal) for c in centers]


def anywhere(rng, texture):
    centers = [np.array([rng.uniform(-1.5, 1.5), rng.uniform(-1, 1), rng.uniform(2.2, 3.5)]) for _ in range(NUM_FLAT)]
    return [flat_view(texture, c, looking_at(c, [*rng.uniform(-0.2, 0.2, 2), 0]), rng) for c in centers]


def in_equal_steps(rng, texture):
    """A step shifts what is in the plane by one period."""
    centers = [np.array([-0.55 + 0.1 * i, 0, 3.0]) for i in range(NUM_FLAT)]
    straight = looking_at(np.array([0, 0, 3.0]))
    return [flat_view(texture, c, straight, rng) for c in centers]


def hardly_moving(rng, texture):
    centers = [np.array([0.002 * i, 0.001 * (i % 3), 3.0]) for i in range(30)]
    return [flat_view(texture, c, looking_at(c), rng) for c in centers]


# What makes cameras wrong.


def center_of(views):
    """The point nearest to all axes."""
    sums = [(np.eye(3) - np.outer(v.rotation[2], v.rotation[2])) for v in views]
    return np.linalg.lstsq(sum(sums), sum(s @ v.center for s, v in zip(sums, views)), rcond=None)[0]


def moved(views, chosen, degrees=0.0, shift=0.0, scale=1.0, axis=(0.3, 0.5, 1)):
    """A similarity transformation of the chosen cameras about the middle of the scene; the shift in typical distances."""
    middle = center_of(views)
    distance = np.median([np.linalg.norm(v.center - middle) for v in views])
    axis = np.array(axis) / np.linalg.norm(axis)
    turn = cv2.Rodrigues(axis * np.radians(degrees))[0]
    by = shift * distance * np.array([0.8, 0.6, 0])
    return [replace(v, center=turn @ (scale * (v.center - middle)) + middle + by, rotation=v.rotation @ turn.T) if c else v
            for v, c in zip(views, chosen)]


def second_half(views):
    return [2 * i >= len(views) for i in range(len(views))]


def every_second(views):
    return [i % 2 == 1 for i in range(len(views))]


def with_pictures(views, order):
    return [replace(v, picture=views[k].picture, camera_model=views[k].camera_model, parameters=views[k].parameters)
            for v, k in zip(views, order)]


def mirrored(views):
    return [replace(v, picture=np.ascontiguousarray(v.picture[:, ::-1])) for v in views]


def copies(views, rng):
    one = views[len(views) // 2]
    noise = [rng.integers(-2, 3, one.picture.shape) for _ in views]
    return [replace(v, picture=np.clip(one.picture + n, 0, 255).astype(np.uint8), camera_model=one.camera_model, parameters=one.parameters)
            for v, n in zip(views, noise)]


HALVES = {
    "turned": lambda v: moved(v, second_half(v), degrees=1),
    "turned-2": lambda v: moved(v, second_half(v), degrees=2),
    "moved": lambda v: moved(v, second_half(v), shift=0.02),
    "scaled": lambda v: moved(v, second_half(v), scale=1.05),
    "merged": lambda v: moved(v, every_second(v), degrees=1, shift=0.01),
    "far": lambda v: moved(v, every_second(v), scale=1.1),
}


def exchanged(seed):
    return {
        "next-name": lambda v: with_pictures(v, np.roll(range(len(v)), 1)),
        "reversed-names": lambda v: with_pictures(v, range(len(v))[::-1]),
        "permuted": lambda v: with_pictures(v, np.random.default_rng(seed).permutation(len(v))),
        "mirrored": mirrored,
        "one-picture": lambda v: copies(v, np.random.default_rng(seed)),
    }


def scenes(sample, data, seed):
    """All of them; data sets that are not there are left out. Each has random numbers of its own."""
    base = {}
    for light in ("day", "evening", "lamp", "mixed"):
        base[light] = lambda light=light: read_views(sample / light / "images", sample / "day/sparse")
    sets = {"room": ("room/images", "room/sparse/0"), "bench": ("bench/images", "bench/sparse/0"), "bench-sfm": ("bench/images", "bench/sparse-sfm/0"),
            "midday": ("pavilion/midday/images", "pavilion/midday/sparse/0"), "pavilion-mixed": ("pavilion/mixed/images", "pavilion/mixed/sparse/0"),
            "vase": ("vase/images", "vase/sparse/0"), "dodecahedron": ("abc-00000952/images", "abc-00000952/sparse/0"),
            "herz-jesu-p8": ("herz-jesu-p8/images", "herz-jesu-p8/sparse/0"), "desk": ("desk/images", "desk/sparse/0")}
    for name, (images, sparse) in sets.items():
        if (data / sparse).exists():
            base[name] = lambda images=images, sparse=sparse: read_views(data / images, data / sparse)

    def right(name, make):
        return Scene(name, make, is_right=True)

    def wrong(name, make, base=""):
        return Scene(name, make, base)

    found = [right(name, make) for name, make in base.items()]
    for name in base:
        if name not in ("herz-jesu-p8", "evening", "vase"):
            found.append(right(name + "-every-second", lambda name=name: base[name]()[::2]))
    for name in ("day", "room", "bench", "midday"):
        if name in base:
            found.append(right(name + "-nine", lambda name=name: base[name]()[3:12]))
            for kind, change in HALVES.items():
                found.append(wrong(f"{name}-{kind}", lambda name=name, change=change: change(base[name]()), name))
    for name in ("day", "room"):
        if name in base:
            for kind, change in exchanged(seed).items():
                found.append(wrong(f"{name}-{kind}", lambda name=name, change=change: change(base[name]())))
    for k in (1, 2, 3):
        texture = texture_of([seed, k])
        arc = lambda texture=texture, k=k: on_arc(np.random.default_rng(k), texture)
        around = lambda texture=texture, k=k: anywhere(np.random.default_rng(k), texture)
        found += [right(f"art-{k}-arc", arc), right(f"art-{k}-anywhere", around)]
        for kind, change in exchanged(seed).items():
            found.append(wrong(f"art-{k}-{kind}", lambda make=(arc, around)[k % 2], change=change: change(make())))
    for kind in ("turned", "scaled", "far"):
        found.append(wrong(f"art-3-{kind}", lambda make=arc, change=HALVES[kind]: change(make()), "art-3-arc"))
    for texture in (stripes, checkers, windows):
        name = texture.__name__
        found.append(right(f"{name}-arc", lambda t=texture: on_arc(np.random.default_rng(1), t(None))))
        found.append(right(f"{name}-anywhere", lambda t=texture: anywhere(np.random.default_rng(1), t(None))))
        found.append(wrong(f"{name}-equal-steps", lambda t=texture: in_equal_steps(np.random.default_rng(1), t(None))))
    found.append(right("art-long-lens", lambda: on_arc(np.random.default_rng(4), texture_of(4), 60.0, 20 * FOCAL)))
    found.append(wrong("art-hardly-moving", lambda: hardly_moving(np.random.default_rng(4), texture_of(4))))
    return found


def texture_of(seed):
    return art(np.random.default_rng(seed))
