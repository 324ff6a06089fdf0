# SPDX-License-Identifier: BSD-3-Clause
"""Reads the cameras of COLMAP's binary models, and compares places of cameras. Needs numpy only."""

import struct

import numpy as np

PARAMETER_COUNTS = {"SIMPLE_PINHOLE": 3, "PINHOLE": 4, "SIMPLE_RADIAL": 4, "RADIAL": 5, "OPENCV": 8}
MODELS = list(PARAMETER_COUNTS)  # by COLMAP's id


def rotation_of(quaternion):
    """Of (w, x, y, z), of any length."""
    w, *v = np.asarray(quaternion, float) / np.linalg.norm(quaternion)
    cross = np.cross(np.eye(3), v)  # [v]x
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def read_cameras(path):
    """By id: model, (width, height), parameters."""
    cameras = {}
    with open(path, "rb") as file:
        for _ in range(*struct.unpack("<Q", file.read(8))):
            key, model, width, height = struct.unpack("<iiQQ", file.read(24))
            if model >= len(MODELS):
                raise SystemExit(f"ERROR: {path}: cameras must be of the models {', '.join(MODELS)}")
            count = PARAMETER_COUNTS[MODELS[model]]
            cameras[key] = MODELS[model], (width, height), list(struct.unpack(f"<{count}d", file.read(8 * count)))
    return cameras


def read_images(path):
    """By name: rotation, translation, id of the camera."""
    images = {}
    with open(path, "rb") as file:
        for _ in range(*struct.unpack("<Q", file.read(8))):
            _, *pose, camera = struct.unpack("<i7di", file.read(64))
            name = b"".join(iter(lambda: file.read(1), b"\0")).decode()
            file.seek(24 * struct.unpack("<Q", file.read(8))[0], 1)
            images[name] = rotation_of(pose[:4]), np.array(pose[4:]), camera
    return images


def similarity(source, target):
    """(scale, rotation, translation) that brings points nearest to others, rows."""
    mean_s, mean_t = source.mean(0), target.mean(0)
    u, s, v = np.linalg.svd((target - mean_t).T @ (source - mean_s))
    flip = np.array([1, 1, np.sign(np.linalg.det(u @ v))])
    rotation, scale = u * flip @ v, s @ flip / np.square(source - mean_s).sum()
    return scale, rotation, mean_t - scale * rotation @ mean_s


def misplacement(centers, true_centers):
    """Mean distance of cameras from where they should be, after a similarity, over that from their middle."""
    scale, rotation, translation = similarity(centers, true_centers)
    errors = np.linalg.norm(scale * centers @ rotation.T + translation - true_centers, axis=1)
    return errors.mean() / np.linalg.norm(true_centers - true_centers.mean(0), axis=1).mean()
