# SPDX-License-Identifier: BSD-3-Clause
"""Checks that COLMAP's mapper registers the views, and makes real points for the day's workspace.

  /usr/bin/python3 sift_points.py --sample datasets/sample --work /tmp/colmap [--points] [--sets day]

The mapper is only a check (its poses are not used). With --points, features of the day are triangulated with the
exact poses held fixed and the points seen by the most views are written to day/sparse.
"""

import argparse
import os
import sqlite3
import subprocess
from pathlib import Path

import scene
from colmap_files import write_binary_model, write_text_model
from make_workspaces import SETS

MAX_POINTS = 1500
MIN_TRACK = 3


def pinhole():
    return (scene.FOCAL_PX, scene.FOCAL_PX, *scene.PRINCIPAL_POINT)


def exact_images():
    return [(scene.view_name(i), *scene.camera_pose(i)) for i in range(scene.VIEW_COUNT)]


def colmap(command, *arguments):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    run = subprocess.run(["colmap", command, *map(str, arguments)], env=environment,
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(f"colmap {command} failed:\n{run.stdout[-2000:]}\n{run.stderr[-2000:]}")
    return run.stdout


def match(images, work):
    """Database with features and matches of all pairs."""
    database = work / "database.db"
    work.mkdir(parents=True, exist_ok=True)
    database.unlink(missing_ok=True)
    colmap("feature_extractor", "--database_path", database, "--image_path", images,
           "--ImageReader.single_camera", 1, "--SiftExtraction.use_gpu", 0, "--SiftExtraction.num_threads", 2)
    colmap("exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu", 0,
           "--SiftMatching.num_threads", 2)
    return database


def registered_by_mapper(database, images, work):
    """Number of images in the mapper's largest model."""
    output = work / "mapper"
    output.mkdir(exist_ok=True)
    colmap("mapper", "--database_path", database, "--image_path", images, "--output_path", output,
           "--Mapper.num_threads", 2)
    counts = []
    for model in output.iterdir():
        data = (model / "images.bin").read_bytes()[:8]
        counts.append(int.from_bytes(data, "little"))
    return max(counts, default=0)


def triangulate(database, images, work):
    """COLMAP's points with the exact poses, as text files. COLMAP wants the image ids of its database."""
    with sqlite3.connect(database) as connection:
        ids = dict(connection.execute("SELECT name, image_id FROM images"))
    model = work / "exact"
    exact = exact_images()
    write_text_model(model, "PINHOLE", (scene.WIDTH, scene.HEIGHT), pinhole(), exact,
                     [ids[name] for name, _, _ in exact])
    for name in ("triangulated", "text"):
        (work / name).mkdir(exist_ok=True)
    colmap("point_triangulator", "--database_path", database, "--image_path", images, "--input_path", model,
           "--output_path", work / "triangulated")
    colmap("model_converter", "--input_path", work / "triangulated", "--output_path", work / "text",
           "--output_type", "TXT")
    return work / "text"


def read_observations(path):
    """{image name: (image id, [(x, y)])} of an images.txt without blanks in its names."""
    lines = [line for line in path.read_text().split("\n") if not line.startswith("#")]
    result = {}
    for head, tail in zip(lines[0::2], lines[1::2]):
        if head:
            values = list(map(float, tail.split()))
            result[head.split()[9]] = (int(head.split()[0]), list(zip(values[0::3], values[1::3])))
    return result


def write_points(text, sample):
    """Rewrites day/sparse with exact poses and the triangulated points seen most often."""
    seen = read_observations(text / "images.txt")
    index_of_id = {seen[name][0]: i for i, name in enumerate(map(scene.view_name, range(scene.VIEW_COUNT)))}
    xy_of_id = {image_id: xy for image_id, xy in seen.values()}
    rows = [line.split() for line in (text / "points3D.txt").read_text().splitlines() if not line.startswith("#")]
    rows = [row for row in rows if len(row) >= 8 + 2 * MIN_TRACK]
    rows.sort(key=lambda row: (-len(row), int(row[0])))
    observations = [[] for _ in range(scene.VIEW_COUNT)]
    points = []
    for number, row in enumerate(rows[:MAX_POINTS], 1):
        track = []
        for image_id, index in zip(map(int, row[8::2]), map(int, row[9::2])):
            view = index_of_id[image_id]
            track.append((view + 1, len(observations[view])))
            observations[view].append((*xy_of_id[image_id][index], number))
        points.append((number, tuple(map(float, row[1:4])), tuple(map(int, row[4:7])), float(row[7]), track))
    write_binary_model(sample / "day" / "sparse", "PINHOLE", (scene.WIDTH, scene.HEIGHT), pinhole(),
                       exact_images(), observations, points)
    print(f"day: {len(points)} points of {len(rows)} written")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--sets", default=",".join(SETS))
    parser.add_argument("--points", action="store_true")
    arguments = parser.parse_args()
    for name in arguments.sets.split(","):
        images, work = arguments.sample / name / "images", arguments.work / name
        database = match(images, work)
        if name == "day" and arguments.points:
            write_points(triangulate(database, images, work), arguments.sample)
        print(f"{name}: the mapper registers {registered_by_mapper(database, images, work)} of {scene.VIEW_COUNT}",
              flush=True)


if __name__ == "__main__":
    main()
