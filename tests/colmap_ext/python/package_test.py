#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel: built by pip, installed into a new environment, where the examples run and mypy finds the types.

Argument: the build tree, whose libraries the wheel takes.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import scenes

BUILD = Path(sys.argv.pop(1)).resolve()
ROOT = Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "colmap_ext/python"

# In place of CMake: it configures, but has the package of the build tree instead of hours of building.
CMAKE = """#!/bin/sh
set -e
[ "$1" = --build ] || exec {cmake} "$@"
{cmake} --build "$2" "$3" "$4" -- -n > /dev/null
mkdir -p "$2/python"
cp -r {build}/python/limn "$2/python"
"""


def run(*command, **options):
    done = subprocess.run([str(one) for one in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}:\n{done.stdout}")
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        cls.environment = {**environment, "LIMN_BUILD_DIR": str(BUILD), "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
        before = set(PACKAGE.rglob("*"))
        # As the documentation says, without a network.
        (command,) = re.findall(r"`pip (wheel .*?)`", (ROOT / "colmap_ext/docs/python.md").read_text(encoding="utf-8"))
        run(sys.executable, "-m", "pip", *command.split(), "-w", cls.folder, cwd=ROOT,
            env={**cls.environment, "PIP_NO_INDEX": "1"})
        cls.left = set(PACKAGE.rglob("*")) - before
        run(sys.executable, "-m", "venv", "--system-site-packages", cls.folder / "venv")
        cls.python = cls.folder / "venv/bin/python"
        (wheel,) = cls.folder.glob("limn_colmap-*.whl")
        run(cls.python, "-m", "pip", "install", "--no-deps", "--no-index", wheel, env=cls.environment)

    def python_says(self, *arguments):
        return run(self.python, *arguments, cwd=self.folder, env=self.environment)

    def test_is_installed_with_its_types(self):
        path = Path(self.python_says("-c", "import limn; print(limn.__file__)").strip()).parent
        self.assertIn(self.folder, path.parents)
        for name in ("py.typed", "_limn.pyi"):
            self.assertTrue((path / name).exists(), name)
        self.assertEqual(self.left, set())

    def test_examples(self):
        said = self.python_says(PACKAGE / "examples/first_drawing.py", scenes.DAY, self.folder / "out")
        self.assertIn("longest link", said)
        for name in ("drawing.json", "drawing.glb", "drawing.dxf"):
            self.assertTrue((self.folder / "out" / name).exists(), name)
        self.assertIn("median standard deviation", self.python_says(PACKAGE / "examples/from_memory.py", scenes.DAY))

    def copy_of_sources(self, name):
        source = self.folder / name
        for folder in ("src", "colmap_ext", "scripts"):
            shutil.copytree(ROOT / folder, source / folder)
        for file in ("CMakeLists.txt", "LICENSE"):
            shutil.copy(ROOT / file, source)
        return source

    def wheel_with_cmake(self, source, cmake, **environment):
        """Made from these sources with this script in place of CMake, and no build tree named."""
        tools = source / "tools"
        tools.mkdir()
        (tools / "cmake").write_text(cmake, encoding="utf-8")
        (tools / "cmake").chmod(0o755)
        environment = {**self.environment, "PATH": f"{tools}:{os.environ['PATH']}", **environment}
        del environment["LIMN_BUILD_DIR"]
        run(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index",
            "-w", source / "wheels", source / "colmap_ext/python", env=environment)
        (wheel,) = (source / "wheels").glob("limn_colmap-*.whl")
        return wheel

    def test_a_finished_build_is_used(self):
        source = self.copy_of_sources("finished")
        shutil.copytree(BUILD / "python/limn", source / "build/release/python/limn")
        log = self.folder / "finished.log"
        self.wheel_with_cmake(source, f'#!/bin/sh\necho "$@" >> {log}\n')
        (line,) = log.read_text(encoding="utf-8").splitlines()
        self.assertTrue(line.startswith(f"--build {source}/build/release --target limn_python_package"), line)

    def test_is_configured_without_a_build_tree(self):
        source = self.copy_of_sources("source")
        wheel = self.wheel_with_cmake(source, CMAKE.format(cmake=shutil.which("cmake"), build=BUILD),
                                      LIMN_CMAKE_ARGS="-DLIMN_WITH_STEP=OFF -DLIMN_WITH_MPI=OFF")
        with zipfile.ZipFile(wheel) as files:
            self.assertIn("limn/_limn.pyi", files.namelist())
        cache = (source / "build/wheel/CMakeCache.txt").read_text(encoding="utf-8")
        for setting in ("BUILD_SHARED_LIBS:BOOL=OFF", "CMAKE_BUILD_TYPE:STRING=Release", "LIMN_BUILD_TESTS:BOOL=OFF",
                        "LIMN_WITH_PYTHON:BOOL=ON", "LIMN_WITH_STEP:BOOL=OFF", "LIMN_WITH_MPI:BOOL=OFF"):
            self.assertIn(f"\n{setting}\n", cache)
        self.assertRegex(cache, rf"\nPython_EXECUTABLE:\w+={re.escape(sys.executable)}\n")

    def test_types(self):
        if not shutil.which("mypy"):
            self.skipTest("mypy is not installed")
        def errors_of(*arguments):
            done = subprocess.run(["mypy", "--strict", "--python-executable", self.python, *arguments], text=True,
                                  cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, check=False)
            return done.stdout
        self.assertRegex(errors_of("-p", "limn"), "^Success")
        right = self.folder / "right.py"
        right.write_text('import limn\nimport numpy as np\nfrom numpy.typing import NDArray\n'
                         'drawing: limn.Drawing = limn.draw("w", box=[0, 1], progress=print)\n'
                         'points: NDArray[np.float64] = drawing.links[0].points\n'
                         'names: list[str] = [link.kind for link in drawing.links]\n'
                         'tracks = drawing.links[0].tracks["a.jpg"]\n'
                         'limn.Scene.from_arrays([], 1, 2, 3)\n')
        self.assertRegex(errors_of(right), "^Success")
        wrong = self.folder / "wrong.py"
        wrong.write_text('import limn\nlimn.draw(5)\nlimn.read_drawing("x").links[0].kinds\n'
                         'points: str = limn.read_drawing("x").links[0].points\nlimn.draw("w", progress=3)\n')
        self.assertRegex(errors_of(wrong), "Found 4 errors")


if __name__ == "__main__":
    unittest.main()
