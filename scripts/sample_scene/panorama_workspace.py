# SPDX-License-Identifier: BSD-3-Clause
"""A COLMAP workspace of panoramas at the places of the sample scene's photographs: JPEG files and the exact cameras.

  /usr/bin/python3 panorama_workspace.py --frames /tmp/frames --output /tmp/panoramas
"""

import argparse
from pathlib import Path

import cv2

import scene
from colmap_files import write_binary_model
from make_workspaces import JPEG_QUALITY


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    images = arguments.output / "images"
    images.mkdir(parents=True, exist_ok=True)
    poses = []
    for index in range(scene.VIEW_COUNT):
        frame = cv2.imread(str(arguments.frames / f"view_{index:02d}.png"))
        cv2.imwrite(str(images / scene.view_name(index)), frame, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
        poses.append((scene.view_name(index), *scene.camera_pose(index)))
    height, width = frame.shape[:2]
    write_binary_model(arguments.output / "sparse" / "0", "EQUIRECTANGULAR", (width, height), (width, height), poses)


if __name__ == "__main__":
    main()
