# SPDX-License-Identifier: BSD-3-Clause
"""Turns rendered frames into COLMAP workspaces: JPEG files and models with the exact cameras.

  /usr/bin/python3 make_workspaces.py --frames /tmp/frames --sample datasets/sample [--sets day,evening]
"""

import argparse
from pathlib import Path

import cv2

import lens
import scene
from colmap_files import write_binary_model, write_text_model

JPEG_QUALITY = 90
SETS = ("day", "evening", "lamp", "mixed", "distorted")


def light_of_mixed_view(index):
    """The mixed set takes the lights in turn; its images are symbolic links into the other sets."""
    return scene.LIGHTS[index % len(scene.LIGHTS)]


def write_images(name, frames, sample):
    folder = sample / name / "images"
    folder.mkdir(parents=True, exist_ok=True)
    for index in range(scene.VIEW_COUNT):
        target = folder / scene.view_name(index)
        if name == "mixed":
            target.unlink(missing_ok=True)
            target.symlink_to(Path("../..") / light_of_mixed_view(index) / "images" / scene.view_name(index))
            continue
        image = cv2.imread(str(frames / name / f"view_{index:02d}.png"))
        cv2.imwrite(str(target), image, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])


def write_model(name, sample):
    size = (scene.WIDTH, scene.HEIGHT)
    images = [(scene.view_name(i), *scene.camera_pose(i)) for i in range(scene.VIEW_COUNT)]
    if name == "distorted":
        parameters = (lens.FOCAL_PX, lens.FOCAL_PX, *lens.PRINCIPAL_POINT, lens.K1, lens.K2, 0.0, 0.0)
        write_binary_model(sample / name / "sparse" / "0", "OPENCV", size, parameters, images)
        return
    parameters = (scene.FOCAL_PX, scene.FOCAL_PX, *scene.PRINCIPAL_POINT)
    if name == "day":
        write_binary_model(sample / name / "sparse", "PINHOLE", size, parameters, images)
    elif name == "evening":
        write_text_model(sample / name / "sparse" / "0", "PINHOLE", size, parameters, images)
    else:
        write_binary_model(sample / name / "sparse" / "0", "PINHOLE", size, parameters, images)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=Path, required=True)
    parser.add_argument("--sample", type=Path, required=True)
    parser.add_argument("--sets", default=",".join(SETS))
    arguments = parser.parse_args()
    for name in arguments.sets.split(","):
        write_images(name, arguments.frames, arguments.sample)
        write_model(name, arguments.sample)


if __name__ == "__main__":
    main()
