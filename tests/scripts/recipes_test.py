#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of packages and images, and the workflows of the hosting site, agree with the tree: versions, dependencies, options, scripts.

Their own systems do not run here. YAML files need PyYAML (Debian: python3-yaml), the formula ruby, the port cmake; where one is
missing the test says what it skipped."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "scripts" / "packaging"
sys.path.insert(0, str(PACKAGING))

import fill_recipes  # noqa: E402

try:
    import yaml
except ImportError:
    yaml = None

CONDA = PACKAGING / "conda" / "recipe.yaml"
VCPKG = PACKAGING / "vcpkg" / "limn" / "vcpkg.json"
PORTFILE = PACKAGING / "vcpkg" / "limn" / "portfile.cmake"
FORMULA = PACKAGING / "homebrew" / "limn.rb"
DOCKERFILE = PACKAGING / "docker" / "Dockerfile"
WORKFLOWS = sorted((ROOT / "scripts/packaging/github").glob("*.yml"))

# What the build looks for -> its packages in conda-forge, vcpkg and Homebrew.
DEPENDENCIES = {
    "Eigen3": ("eigen", "eigen3", "eigen"),
    "Ceres": ("ceres-solver", "ceres", "ceres-solver"),
    "glog": ("glog", "glog", "glog"),
    "OpenCV": ("libopencv", "opencv4", "opencv"),
    "ICU": ("icu", "icu", "icu4c@78"),
    "JPEG": ("libjpeg-turbo", "libjpeg-turbo", "jpeg-turbo"),
    "TBB": ("tbb-devel", "tbb", "tbb"),
    "ZLIB": ("zlib", "zlib", "zlib"),
    "SQLite3": ("sqlite", "sqlite3", "sqlite"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json", "nlohmann-json"),
    "Boost": ("libboost-devel", "boost-program-options", "boost"),
    "flann/flann.hpp": ("flann", "flann", "flann"),
    "lz4": ("lz4-c", "lz4", "lz4"),
    "tiny_gltf.h": ("tinygltf", "tinygltf", "tinygltf"),
    # vcpkg has no ports of these: a feature of the port says that they must be in PATH.
    "node": ("nodejs", None, "node"),
    "npm": ("nodejs", None, "node"),
}
# What the build looks for only if an option is on -> the option, which recipes without the package turn off.
OPTIONAL = {
    "OpenCASCADE": "LIMN_WITH_STEP",
    "MPI": "LIMN_WITH_MPI",
    "Python": "LIMN_WITH_PYTHON",
    "pybind11": "LIMN_WITH_PYTHON",
    "COLMAP": "LIMN_WITH_COLMAP",
    "GTest": "LIMN_BUILD_TESTS",
}
# A commit for limn --version, which archives do not have; a faster second build; what serves where FLANN is missing.
NOT_NEEDED = {"Git", "ccache", "nanoflann.hpp"}


def read(path):
    return path.read_text(encoding="utf-8")


def cmake_files():
    return [ROOT / "CMakeLists.txt", *(ROOT / "scripts").glob("*.cmake"), *(ROOT / "src").rglob("CMakeLists.txt"),
            *(ROOT / "colmap_ext").rglob("CMakeLists.txt")]


def looked_for():
    """Names that the build looks for by CMake's commands, and headers that are compiled in without it."""
    names = {"tiny_gltf.h"}
    for path in cmake_files():
        text = re.sub(r"#.*", "", read(path))
        names |= set(re.findall(r"\bfind_package\(\s*(\w+)", text))
        names |= set(re.findall(r"\bfind_(?:path|library|program)\(\s*\w+\s+([\w./]+)", text))
    return names


def options_of_build():
    return {name for path in [*cmake_files(), *PACKAGING.glob("*.cmake")] for name in re.findall(r"\boption\((\w+)", read(path))}


def project_version():
    return re.search(r"^project\(limn VERSION ([\d.]+)", read(ROOT / "CMakeLists.txt"), re.M).group(1)


def conda_packages():
    """Names in the requirements of the recipe; read without PyYAML, so that this test is never skipped."""
    text = re.search(r"^requirements:\n((?:  .*\n)+)", read(CONDA), re.M).group(1).split("  run_exports:")[0]
    return set(re.findall(r"^    - ([\w-]+)(?: \S+)?$", text, re.M))


def vcpkg_packages():
    return {entry if isinstance(entry, str) else entry["name"] for entry in json.loads(read(VCPKG))["dependencies"]}


def formula_packages():
    return set(re.findall(r'^  (?:depends_on|resource) "([^"]+)"', read(FORMULA), re.M))


class Versions(unittest.TestCase):
    def test_all_are_the_project_s(self):
        version = project_version()
        found = {
            "conda": re.search(r'^  version: "(.*)"$', read(CONDA), re.M).group(1),
            "vcpkg": json.loads(read(VCPKG))["version"],
        }
        found |= {f"formula {number}": text for number, text in
                  enumerate(re.findall(r"releases/download/v([\d.]+)/", read(FORMULA)) + re.findall(r"/limn-([\d.]+\d)", read(FORMULA)))}
        self.assertEqual({name: text for name, text in found.items() if text != version}, {}, f"CMakeLists.txt has {version}")
        self.assertEqual(len(found), 6)


class Dependencies(unittest.TestCase):
    def test_what_the_build_looks_for_is_known(self):
        names = looked_for()
        self.assertIn("Ceres", names)
        self.assertEqual(names - set(DEPENDENCIES) - set(OPTIONAL) - NOT_NEEDED, set(),
                         "add what the build looks for to a table of this test, and to every recipe")
        self.assertEqual((set(DEPENDENCIES) | set(OPTIONAL) | NOT_NEEDED) - names, set(), "the build does not look for these any more")

    def test_every_recipe_has_every_dependency(self):
        for column, packages in enumerate((conda_packages(), vcpkg_packages(), formula_packages())):
            wanted = {names[column] for names in DEPENDENCIES.values()} - {None}
            self.assertEqual(wanted - packages, set(), ("conda", "vcpkg", "homebrew")[column])

    def test_options_without_packages_are_off(self):
        known = options_of_build()
        for path in (CONDA, PORTFILE, FORMULA):
            given = dict(re.findall(r"-D((?:LIMN|BUILD)_\w+)=(\w+)", read(path)))
            self.assertEqual(set(given) - known, set(), f"{path}: no such options")
            for option in OPTIONAL.values():
                self.assertEqual(given.get(option), "OFF", f"{path}: {option}")

    def test_parts_of_boost_are_ports_of_their_own(self):
        sources = [path for folder in ("src", "colmap_ext") for path in (ROOT / folder).rglob("*") if path.suffix in (".cc", ".h")]
        parts = {part for path in sources for part in re.findall(r"#include <boost/(\w+)", read(path))} - {"mpi"}
        self.assertTrue(parts)
        self.assertEqual({f"boost-{part.replace('_', '-')}" for part in parts} - vcpkg_packages(), set())


class Syntax(unittest.TestCase):
    @unittest.skipUnless(yaml, "SKIPPED: YAML files are not parsed without PyYAML (python3-yaml)")
    def test_yaml(self):
        recipe = yaml.safe_load(read(CONDA))
        self.assertEqual(recipe["schema_version"], 1)
        self.assertEqual(set(recipe["requirements"]), {"build", "host", "run_exports"})
        for path in WORKFLOWS:
            self.assertIn("jobs", yaml.safe_load(read(path)), path)

    @unittest.skipUnless(shutil.which("ruby"), "SKIPPED: the formula is not parsed without ruby")
    def test_formula(self):
        run = subprocess.run(["ruby", "-c", FORMULA], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)

    @unittest.skipUnless(shutil.which("cmake"), "SKIPPED: the port is not run without cmake")
    def test_port(self):
        for features in ("core", "core;viewer"):
            with tempfile.TemporaryDirectory() as folder:
                run = subprocess.run(["cmake", f"-DPORTFILE={PORTFILE}", f"-DFEATURES={features}", "-P",
                                      Path(__file__).with_name("portfile_stand_ins.cmake")],
                                     capture_output=True, text=True, cwd=folder, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            viewer = "viewer" in features
            self.assertIn(f"-DLIMN_WITH_VIEWER={'ON' if viewer else 'OFF'};", run.stdout.replace(" ", ";"))
            self.assertEqual("cache /extracted/limn-1.2.3-npm-cache" in run.stdout, viewer)
            self.assertEqual(run.stdout.count("three/LICENSE"), 1 if viewer else 0)
            self.assertIn("vcpkg_copy_tools", run.stdout)


class Filling(unittest.TestCase):
    def test_all_marks_are_filled_in(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "limn.tar.gz").write_bytes(b"sources")
            (root / "npm.tar.gz").write_bytes(b"cache")
            subprocess.run([PACKAGING / "fill_recipes.py", "--repository", "someone/limn", "--maintainer", "someone", "--archive",
                            root / "limn.tar.gz", "--npm_cache", root / "npm.tar.gz", "--output", root / "out"], check=True, capture_output=True)
            texts = {name: read(root / "out" / name) for name in fill_recipes.RECIPES}
        for name, text in texts.items():
            self.assertNotRegex(text, r"@LIMN", name)
        for name in ("conda/recipe.yaml", "homebrew/limn.rb"):
            for content in (b"sources", b"cache"):
                self.assertIn(hashlib.sha256(content).hexdigest(), texts[name])
        for content in (b"sources", b"cache"):
            self.assertIn(f"SHA512 {hashlib.sha512(content).hexdigest()}", texts["vcpkg/limn/portfile.cmake"])
        self.assertIn("https://github.com/someone/limn/releases/", texts["homebrew/limn.rb"])

    def test_no_recipe_is_forgotten(self):
        marked = {path.relative_to(PACKAGING).as_posix() for path in PACKAGING.rglob("*")
                  if path.is_file() and path.suffix in (".yaml", ".json", ".cmake", ".rb") and fill_recipes.MARK.search(read(path))}
        self.assertEqual(marked, set(fill_recipes.RECIPES))

    def test_bad_arguments(self):
        for arguments, message in ((["--repository", "limn"], "not of the form OWNER/NAME"), (["--repository", "a/b"], "no such file")):
            run = subprocess.run([PACKAGING / "fill_recipes.py", *arguments, "--maintainer", "a", "--archive", "/nowhere", "--npm_cache",
                                  "/nowhere", "--output", "/nowhere"], capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 1)
            self.assertIn(message, run.stderr)


def commands_of(path):
    """The shell text of a workflow or of a Dockerfile, without comments."""
    return "\n".join(line for line in read(path).split("\n") if not line.lstrip().startswith("#"))


class Commands(unittest.TestCase):
    def test_scripts_exist_and_can_be_run(self):
        for path in (*WORKFLOWS, DOCKERFILE):
            names = {name.rstrip("/.") for name in re.findall(r"\b(?:scripts|tests|colmap_ext)/[\w./-]*", commands_of(path))}
            self.assertTrue(names, path)
            for name in names:
                self.assertTrue((ROOT / name).exists(), f"{path}: {name}")
                if (ROOT / name).suffix in (".sh", ".py"):
                    self.assertTrue(os.access(ROOT / name, os.X_OK), f"{path}: {name} cannot be run")

    def test_packages_come_from_setup(self):
        for path in (*WORKFLOWS, DOCKERFILE):
            text = commands_of(path)
            self.assertRegex(text, r"scripts/(setup|test)\.sh", path)
            # Beside it only what checkout needs, and Limn's own package.
            for packages in re.findall(r"apt-get install ((?:[^&\n]|\\\n)*)", text):
                words = set(packages.split()) - {"-y", "--no-install-recommends", "\\"}
                self.assertIn(words, ({"ca-certificates", "git"}, {"/tmp/limn*.deb"}), path)

    def test_presets_and_options_exist(self):
        presets = {preset["name"] for preset in json.loads(read(ROOT / "CMakePresets.json"))["buildPresets"]}
        known = options_of_build()
        for path in (*WORKFLOWS, DOCKERFILE):
            text = commands_of(path)
            self.assertLessEqual(set(re.findall(r"--preset (\w+)", text)), presets, path)
            self.assertLessEqual(set(re.findall(r"-D(LIMN_\w+)=", text)), known, path)

    def test_image(self):
        text = read(DOCKERFILE)
        self.assertEqual(re.findall(r"^FROM (\S+)", text, re.M), ["debian:12", "debian:12-slim"])
        self.assertIn('\nWORKDIR /working\nENTRYPOINT ["limn"]\n', text)
        package = re.search(r"limn_package\(program (\w+)", read(PACKAGING / "packages.cmake")).group(1)
        self.assertIn(f"/packages/{package}_*.deb", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)  # with the reasons of what is skipped
