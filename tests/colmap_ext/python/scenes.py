# SPDX-License-Identifier: BSD-3-Clause
"""Small scenes for the tests of the Python package: eight small images of the sample scene."""

import tempfile
from pathlib import Path

SAMPLE = Path(__file__).resolve().parents[3] / "datasets/sample"
DAY = SAMPLE / "day"
NUM_IMAGES = 8


# Written once, as several threads may read it; it lives as long as the process.
_folder = tempfile.TemporaryDirectory()
_image_list = Path(_folder.name) / "list.txt"
_image_list.write_text("".join(f"view_{i:02d}.jpg\n" for i in range(NUM_IMAGES)), encoding="utf-8")


def small_options():
    """Options for limn.open and the like."""
    return {"image_list_path": _image_list, "quality": "low", "max_image_size": 320, "num_threads": 2}


def files_below(folder):
    """Paths, sizes and times of all files, to see that nothing is written."""
    return {path: (path.stat().st_size, path.stat().st_mtime_ns) for path in sorted(Path(folder).rglob("*"))}
