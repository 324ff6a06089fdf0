"""Small scenes for the tests of the Python package: eight small images of the sample scene."""

import os
import tempfile
from pathlib import Path

SAMPLE = Path(__file__).resolve().parents[3] / "datasets/sample"
DAY = SAMPLE / "day"
NUM_IMAGES = 8


def small_options():
    """Options for limn.open and the like; the file of the list lives as long as the process."""
    names = "".join(f"view_{i:02d}.jpg\n" for i in range(NUM_IMAGES))
    return {"image_list_path": _list_file(names), "quality": "low", "max_image_size": 320, "num_threads": 2}


_folder = tempfile.TemporaryDirectory()


def _list_file(names):
    path = os.path.join(_folder.name, "list.txt")
    Path(path).write_text(names, encoding="utf-8")
    return path


def files_below(folder):
    """Paths, sizes and times of all files, to see that nothing is written."""
    return {path: (path.stat().st_size, path.stat().st_mtime_ns) for path in sorted(Path(folder).rglob("*"))}
