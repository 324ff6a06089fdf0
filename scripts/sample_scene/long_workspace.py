# SPDX-License-Identifier: BSD-3-Clause
"""A COLMAP workspace of the long path: JPEG files, the exact cameras, and a list of images per number of views.

  /usr/bin/python3 long_workspace.py --frames /tmp/frames --output /tmp/long

views-25.txt, views-50.txt and views-100.txt are for --image_list_path; each list is part of the next.
"""

import argparse
from pathlib import Path

import cv2

import scene
from colmap_files import write_binary_model
from make_workspaces import JPEG_QUALITY

STRIDES = (4, 2, 1)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    names = [scene.view_name(i) for i in range(scene.LONG_VIEW_COUNT)]
    images = arguments.output / "images"
    images.mkdir(parents=True, exist_ok=True)
    for index, name in enumerate(names):
        frame = cv2.imread(str(arguments.frames / f"view_{index:02d}.png"))
        cv2.imwrite(str(images / name), frame, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    poses = [(name, *scene.long_camera_pose(i)) for i, name in enumerate(names)]
    write_binary_model(arguments.output / "sparse" / "0", "PINHOLE", (scene.WIDTH, scene.HEIGHT),
                       (scene.FOCAL_PX, scene.FOCAL_PX, *scene.PRINCIPAL_POINT), poses)
    for stride in STRIDES:
        chosen = names[::stride]
        (arguments.output / f"views-{len(chosen)}.txt").write_text("\n".join(chosen) + "\n")


if __name__ == "__main__":
    main()
