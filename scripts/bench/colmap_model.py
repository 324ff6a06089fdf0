# SPDX-License-Identifier: BSD-3-Clause
"""COLMAP's own pipeline on a folder of photographs, as an ordinary user would run it, on the CPU."""

import os
import shutil

from measured_run import CommandFailed, Run


def num_images(model):
    """Of a binary model."""
    with open(model / "images.bin", "rb") as file:
        return int.from_bytes(file.read(8), "little")


def reconstruct(images, camera_model, folder):
    """The folder of the largest model that COLMAP makes, all photographs of one camera; a second call makes it no more."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    done = folder / "done"
    if not done.exists():
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "sparse").mkdir(parents=True)
        database = folder / "database.db"
        Run(["colmap", "feature_extractor", "--database_path", database, "--image_path", images,
             "--ImageReader.single_camera", 1, "--ImageReader.camera_model", camera_model, "--SiftExtraction.use_gpu", 0])
        Run(["colmap", "exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu", 0])
        Run(["colmap", "mapper", "--database_path", database, "--image_path", images, "--output_path", folder / "sparse"])
        done.touch()
    models = sorted(folder.glob("sparse/*"), key=num_images)
    if not models:
        raise CommandFailed(f"{folder}: COLMAP's mapper made no model of {images}: leave this set out with --sets")
    return models[-1].resolve()
