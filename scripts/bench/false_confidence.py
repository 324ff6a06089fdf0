#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does a run warn where cameras are wrong, and only there? Draws right and wrong scenes and counts the warnings.

    false_confidence.py --limn LIMN --output_path FOLDER [--data_path DATA] [--only PATTERN ...] [--seed 1] [options of automatic_drawer]

Needs python3-opencv. Scenes come from the sample scene, from the data sets that DATA has (folders as datasets/RESULTS.md names them), and from
pictures of flat and repetitive things that this script renders. A run warns if it prints a WARNING or the verdict "nonsense".
"Misplaced" is the mean error of the places of cameras that were moved, over their distance from the middle, as given and, if the
run refined them, as refined. Cameras are mended if that is at most twice what right cameras of the same scene end at when they are
refined (--refine_cameras 1). FOLDER/<scene>/ keeps the workspace, the log and the drawing; FOLDER/false_confidence.md has the table,
FOLDER/section.md its counts, as a section of datasets/RESULTS.md.
"""

import argparse
import fnmatch
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "sample_scene"))

from camera_poses import misplacement, rotation_of  # noqa: E402
from colmap_files import quaternion  # noqa: E402
from confidence_section import section  # noqa: E402
from wrong_scenes import scenes  # noqa: E402

MAX_IMAGE_SIZE = 320
ROOT = Path(__file__).resolve().parents[2]
WARNING = re.compile(r"^WARNING: (.*)|^Verdict: (nonsense.*)", re.M)


def write_workspace(scene, folder):
    """A workspace without points: what is wrong must be found in the curves."""
    (folder / "images").mkdir(parents=True)
    (folder / "sparse").mkdir()
    cameras, images = [], []
    for i, view in enumerate(scene.make(), 1):
        height, width = view.picture.shape[:2]
        name = f"view_{i:02}.png"
        cv2.imwrite(str(folder / "images" / name), view.picture, [cv2.IMWRITE_PNG_COMPRESSION, 1])
        cameras.append(f"{i} {view.camera_model} {width} {height} " + " ".join(f"{p:.17g}" for p in view.parameters))
        pose = [*quaternion(view.rotation), *(-view.rotation @ view.center)]
        images.append(f"{i} " + " ".join(f"{p:.17g}" for p in pose) + f" {i} {name}\n")
    (folder / "sparse/cameras.txt").write_text("\n".join(cameras) + "\n")
    (folder / "sparse/images.txt").write_text("\n".join(images) + "\n")
    (folder / "sparse/points3D.txt").write_text("")


def version_of(limn):
    return subprocess.run([limn, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]


def draw(arguments, scene, folder, options):
    """The log of a run; made once for a program, a seed and options."""
    log = folder / "log"
    made_by = f"{arguments.version}, seed {arguments.seed}, options: {' '.join(options)}\n"
    if not log.exists() or not log.read_text().startswith(made_by):
        shutil.rmtree(folder, ignore_errors=True)
        write_workspace(scene, folder)
        begin = time.time()
        run = subprocess.run(["timeout", "600", arguments.limn, "automatic_drawer", "--workspace_path", folder, "--page", "0",
                              "--max_image_size", str(MAX_IMAGE_SIZE), *options], capture_output=True, text=True)
        log.write_text(f"{made_by}{run.stdout}{run.stderr}exit code {run.returncode}, {time.time() - begin:.1f} s\n")
    return log.read_text()


def warnings_in(log):
    return [" ".join(filter(None, match)) for match in WARNING.findall(log)]


def outcome_of(log, is_mended):
    if "\nexit code 0," not in log:
        return "failed"
    return "warned" if warnings_in(log) else "mended" if is_mended else "not warned"


def refined_centers(path):
    """Of a text model, in the order of the names."""
    rows = [line.split() for line in path.read_text().splitlines() if line.endswith(".png")]
    poses = [np.array(row[1:8], float) for row in sorted(rows, key=lambda row: row[9])]
    return np.array([-rotation_of(pose[:4]).T @ pose[4:] for pose in poses])


def misplaced(make, folder):
    """How far the refined cameras of a run are misplaced; None if it left the cameras as they were."""
    refined = folder / "refined/images.txt"
    return misplacement(refined_centers(refined), centers(make)) if refined.exists() else None


def centers(make):
    return np.array([view.center for view in make()])


def mending(scene, base, arguments, options):
    """(whether cameras that were moved are mended, the numbers that say so)"""
    if not base:
        return False, ""
    given = misplacement(centers(scene.make), centers(base.make))
    left = misplaced(base.make, arguments.output_path / scene.name)
    if left is None:
        return False, f"{given:.4f}"
    folder = arguments.output_path / f"{base.name}-refined"
    draw(arguments, base, folder, [*options, "--refine_cameras", "1"])
    floor = misplaced(base.make, folder) or 0
    return left <= 2 * floor, f"{given:.4f} -> {left:.4f}, right ones {floor:.4f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limn", required=True)
    parser.add_argument("--output_path", required=True, type=Path)
    parser.add_argument("--data_path", type=Path, default=ROOT / "../shared/data")
    parser.add_argument("--only", nargs="+", default=["*"])
    parser.add_argument("--seed", type=int, default=1)
    arguments, options = parser.parse_known_args()
    arguments.version = version_of(arguments.limn)
    outcomes = []
    rows = ["| scene | cameras | misplaced | outcome | warnings |", "|---|---|---|---|---|"]
    known = {scene.name: scene for scene in scenes(ROOT / "datasets/sample", arguments.data_path, arguments.seed)}
    for scene in known.values():
        if not any(fnmatch.fnmatch(scene.name, pattern) for pattern in arguments.only):
            continue
        log = draw(arguments, scene, arguments.output_path / scene.name, options)
        found = warnings_in(log)
        is_mended, numbers = mending(scene, known.get(scene.base), arguments, options)
        outcome = outcome_of(log, is_mended)
        outcomes.append((scene, outcome))
        kind, texts = "right" if scene.is_right else "wrong", "; ".join(text[:100] for text in found) or "-"
        rows.append(f"| {scene.name} | {kind} | {numbers} | {outcome} | {texts} |")
        print(rows[-1], flush=True)
    (arguments.output_path / "false_confidence.md").write_text("\n".join(rows) + "\n")
    (arguments.output_path / "section.md").write_text(section(arguments.version, MAX_IMAGE_SIZE, outcomes))


if __name__ == "__main__":
    main()
