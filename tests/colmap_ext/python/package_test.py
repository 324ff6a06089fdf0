#!/usr/bin/env python3
"""The wheel: built by pip, installed into a new environment, where the examples run and mypy finds the types.

Argument: the build tree, whose libraries the wheel takes.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import scenes

BUILD = Path(sys.argv.pop(1)).resolve()
PACKAGE = Path(__file__).resolve().parents[3] / "colmap_ext/python"


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
        run(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", cls.folder,
            PACKAGE, env=cls.environment)
        cls.left = set(PACKAGE.rglob("*")) - before
        run(sys.executable, "-m", "venv", "--system-site-packages", cls.folder / "venv")
        cls.python = cls.folder / "venv/bin/python"
        (wheel,) = cls.folder.glob("limn-*.whl")
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
