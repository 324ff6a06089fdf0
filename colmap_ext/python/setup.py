# SPDX-License-Identifier: BSD-3-Clause
"""Builds the package with CMake: in build/release of the repository if that has it for this Python, or else in
build/wheel; or in another build tree of the same sources that the environment variable LIMN_BUILD_DIR names.
LIMN_CMAKE_ARGS has more arguments for CMake, in build/wheel."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parents[2]
OWN_BUILD = SOURCE / "build/wheel"
FINISHED_BUILD = SOURCE / "build/release"


def version():
    match = re.search(r"^project\(limn VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    if not match:
        raise SystemExit(f"{SOURCE}/CMakeLists.txt: no version")
    return match.group(1)


class BuildWithCmake(build_ext):
    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        is_finished = (FINISHED_BUILD / "python/limn" / target.name).exists()
        folder = Path(os.environ.get("LIMN_BUILD_DIR", FINISHED_BUILD if is_finished else OWN_BUILD))
        if folder == OWN_BUILD:
            generator = ["-G", "Ninja"] if shutil.which("ninja") else []
            subprocess.run(["cmake", "-S", SOURCE, "-B", folder, *generator, "-DCMAKE_BUILD_TYPE=Release",
                            "-DBUILD_SHARED_LIBS=OFF", "-DLIMN_BUILD_TESTS=OFF", "-DLIMN_WITH_PYTHON=ON",
                            f"-DPython_EXECUTABLE={sys.executable}",
                            *shlex.split(os.environ.get("LIMN_CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "limn_python_package", "--parallel",
                        str(os.cpu_count())], check=True)
        target.parent.mkdir(parents=True, exist_ok=True)
        for name in (target.name, "_limn.pyi"):
            shutil.copy(folder / "python/limn" / name, target.parent)
        step = folder / "lib/limn/plugins/limn_step.so"
        if step.exists():
            (target.parent / "lib/limn/plugins").mkdir(parents=True, exist_ok=True)
            shutil.copy(step, target.parent / "lib/limn/plugins")


OWN_BUILD.mkdir(parents=True, exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("limn._limn", sources=[])],
    cmdclass={"build_ext": BuildWithCmake},
    # Nothing is left beside the sources.
    options={"build": {"build_base": str(OWN_BUILD / "setuptools")}, "egg_info": {"egg_base": str(OWN_BUILD)}},
)
