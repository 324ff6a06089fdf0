#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""wheels.py <unpacked archive> <output folder> [--commit-time <seconds>]: a wheel limn_colmap-<version> for each Python
that the archive has a module for, with the program and its libraries in it. `python3 -m wheel` (Debian: python3-wheel)
makes the file."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from glibc_needed import glibc_needed

SOURCE = Path(__file__).resolve().parents[2]


def metadata(version):
    """From pyproject.toml, which is of the same package."""
    project = tomllib.loads((SOURCE / "colmap_ext/python/pyproject.toml").read_text(encoding="utf-8"))["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version}", f"Summary: {project['description']}",
             f"License: {project['license']['text']}", f"Requires-Python: {project['requires-python']}"]
    # The modules of archives know numpy 1 and 2.
    lines += ["Requires-Dist: numpy"]
    for extra, packages in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}"] + [f'Requires-Dist: {package}; extra == "{extra}"' for package in packages]
    return "\n".join(lines) + "\n"


def make_wheel(archive, module, output, commit_time):
    python = re.match(r"_limn\.cpython-(\d+)-", module.name).group(1)
    version = re.match(r"limn-([\d.]+)-", archive.name).group(1)
    major, minor = glibc_needed([archive])["GLIBC"]
    machine = re.search(r"-linux-(\w+)$", archive.name).group(1)
    tag = f"cp{python}-cp{python}-manylinux_{major}_{minor}_{machine}"
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "tree"
        package = tree / "limn"
        shutil.copytree(archive / "python/limn", package, ignore=shutil.ignore_patterns("*.so"))
        shutil.copytree(archive / "lib", package / "lib")
        shutil.copytree(archive / "bin", package / "bin")
        shutil.copy2(module, package)
        # It finds its libraries in the package.
        subprocess.run(["patchelf", "--set-rpath", "$ORIGIN/lib/limn", str(package / module.name)], check=True)
        info = tree / f"limn_colmap-{version}.dist-info"
        (info / "licenses").mkdir(parents=True)
        for name in ("LICENSE", "THIRD_PARTY_NOTICES.txt"):
            shutil.copy2(archive / name, info / "licenses")
        (info / "METADATA").write_text(metadata(version), encoding="utf-8")
        (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: limn\nRoot-Is-Purelib: false\nTag: {tag}\n", encoding="utf-8")
        (info / "entry_points.txt").write_text("[console_scripts]\nlimn = limn._program:main\n", encoding="utf-8")
        subprocess.run([sys.executable, "-m", "wheel", "pack", "--dest-dir", str(output), str(tree)], check=True,
                       env={**os.environ, "SOURCE_DATE_EPOCH": str(commit_time)})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("archive", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("--commit-time", type=int, default=0)
    arguments = parser.parse_args()
    modules = sorted((arguments.archive / "python/limn").glob("_limn.cpython-*.so"))
    if not modules:
        raise SystemExit(f"wheels.py: {arguments.archive}/python/limn has no modules")
    for module in modules:
        make_wheel(arguments.archive, module, arguments.output, arguments.commit_time)


if __name__ == "__main__":
    main()
