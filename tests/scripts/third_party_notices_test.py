#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/packaging/third_party_notices.py on libraries that are installed wherever Limn is built."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PACKAGING = Path(__file__).resolve().parents[2] / "scripts" / "packaging"
sys.path.insert(0, str(PACKAGING))

import debian_licenses  # noqa: E402
import third_party_notices  # noqa: E402

INSTALLED = third_party_notices.loader_paths()


def notices(*arguments):
    """(exit code, page, errors) of a run."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "notices.txt"
        run = subprocess.run([PACKAGING / "third_party_notices.py", "--output", output, *arguments], capture_output=True, text=True, check=False)
        return run.returncode, output.read_text(encoding="utf-8") if output.exists() else "", run.stderr


def version_of(package):
    return subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True, check=True).stdout


class Kinds(unittest.TestCase):
    def test_names(self):
        for name, kind in (("BSD-3-clause", "permissive"), ("GPL-2+", "gpl"), ("LGPL-2.1+", "lgpl"), ("AGPL-3", "gpl"), ("MPL-2.0", "mpl"),
                           ("LGPL-3+ or GPL-2+", "lgpl"), ("GPL-1+ or Artistic", "permissive"), ("BSD-3-clause and GPL-2+", "gpl"),
                           ("GPL-3+ with Bison exception", "permissive"), ("GPL-2 with Font exception", "gpl")):
            self.assertEqual(debian_licenses.kind_of_name(name), kind, name)

    def test_what_is_not_compiled_does_not_count(self):
        text = "Format: x\n\nFiles: *\nLicense: Expat\n text\n\nFiles: debian/* tests/a.c m4/b.m4\nLicense: GPL-3+\n"
        self.assertEqual(debian_licenses.licenses_of_files(text), [("Expat", ["*"])])
        text += "\nFiles: src/a.c\n debian/b\nLicense: GPL-2+\n"
        self.assertEqual(debian_licenses.licenses_of_files(text)[1], ("GPL-2+", ["src/a.c"]))

    def test_files_for_people(self):
        self.assertEqual(debian_licenses.kind_of_text("under the GNU Lesser General\nPublic License, LGPL"), "lgpl")
        self.assertEqual(debian_licenses.kind_of_text("the GNU Lesser General Public License; tests: the GNU General Public License"), "gpl")
        self.assertEqual(debian_licenses.kind_of_text("no conditions"), "permissive")

    def test_reviewed_lines_have_four_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "reviewed.txt"
            path.write_text("# comment\n\nliba | gpl | GPL-2 | all\nlibb | free | X | y\n", encoding="utf-8")
            with self.assertRaisesRegex(SystemExit, r"reviewed\.txt:4: not of the form"):
                debian_licenses.reviewed_licenses(path)


class Chains(unittest.TestCase):
    def test_from_every_program_the_shortest(self):
        needs = {"limn": ["b", "c"], "_limn.so": ["b"], "b": ["d"], "c": ["e"], "e": ["d"], "d": []}
        self.assertEqual(third_party_notices.chains("d", needs), ["limn needs b needs d", "_limn.so needs b needs d"])

    def test_loops_end(self):
        self.assertEqual(third_party_notices.chains("a", {"limn": ["b"], "a": ["b"], "b": ["a"]}), ["limn needs b needs a"])


class Pages(unittest.TestCase):
    def test_a_permissive_library_and_headers(self):
        code, page, errors = notices(INSTALLED["libz.so.1"], "--headers", "libeigen3-dev")
        self.assertEqual((code, errors), (0, ""))
        self.assertIn("Under the GNU GPL: none\n", page)
        self.assertIn(f"zlib1g {version_of('zlib1g')}: libz.so.1 (", page)
        self.assertIn("apt-get source zlib=", page)
        self.assertIn("Jean-loup Gailly", page)
        self.assertIn("libeigen3-dev: headers (MPL-2.0", page)

    def test_common_licenses_are_appended_once(self):
        _, page, _ = notices(INSTALLED["libamd.so.2"], INSTALLED["libglog.so.1"], INSTALLED["libmetis.so.5"], "--headers")
        head = "/usr/share/common-licenses/LGPL-2.1, which texts above refer to"
        self.assertEqual(page.count(head), 1)
        self.assertIn("GNU LESSER GENERAL PUBLIC LICENSE", page[page.index(head):])

    def test_a_copyright_file_of_several_packages_is_printed_once(self):
        _, page, _ = notices(INSTALLED["libamd.so.2"], INSTALLED["libcamd.so.2"], "--headers")
        self.assertEqual(page.count("Upstream-Name: SuiteSparse"), 1)
        self.assertIn("libamd2 ", page)
        self.assertIn("libcamd2 ", page)

    def test_gpl_is_an_error_that_names_dependents(self):
        libraries = [INSTALLED[name] for name in ("libceres.so.3", "libspqr.so.2", "libcholmod.so.3")]
        code, page, errors = notices(*libraries, "--headers")
        self.assertEqual(code, 1)
        self.assertIn("ERROR: libspqr.so.2 (libspqr2) is under the GPL (GPL-2+)\n    libceres.so.3 needs libspqr.so.2\n", errors)
        self.assertIn("ERROR: libcholmod.so.3", errors)
        self.assertIn("Under the GNU GPL:\n  libcholmod3: libcholmod.so.3", page)
        code, page, errors = notices(*libraries, "--headers", "--gpl", "accept")
        self.assertEqual((code, errors), (0, ""))
        self.assertIn("may be passed on only under the GNU General Public License", page)

    def test_our_programs_are_named_and_not_listed(self):
        library = INSTALLED["libspqr.so.2"]
        _, page, errors = notices(library, "--headers", "--users", INSTALLED["libceres.so.3"])
        self.assertIn("libceres.so.3 needs libspqr.so.2", errors)
        self.assertNotIn("\nlibceres3 ", page)

    def test_copies_of_installed_libraries(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(INSTALLED["libz.so.1"], Path(folder) / "libz-0a1b2c3d.so.1")
            shutil.copy(INSTALLED["libsqlite3.so.0"], folder)
            code, page, errors = notices(folder, "--headers")
        self.assertEqual((code, errors), (0, ""))
        self.assertIn("zlib1g ", page)
        self.assertIn("libsqlite3-0 ", page)

    def test_a_library_of_no_package(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "libunknown.so.1"
            # A Python module has no soname by which it could be found.
            shutil.copy(next(Path("/usr/lib/python3").parent.glob("python3*/lib-dynload/*.so")), copy)
            code, _, errors = notices(copy, "--headers")
        self.assertEqual(code, 1)
        self.assertIn("libunknown.so.1: of no Debian package that is installed here; install", errors)

    def test_what_cannot_be_read(self):
        for argument, message in (("/nowhere.so", "/nowhere.so: no such file or folder"), (__file__, "not a shared library")):
            code, page, errors = notices(argument, "--headers")
            self.assertEqual((code, page), (1, ""))
            self.assertIn(message, errors)


class Npm(unittest.TestCase):
    def folder(self, root, with_license):
        packages = {"": {}, "node_modules/small": {}, "node_modules/tool": {"dev": True}}
        (root / "package-lock.json").write_text(json.dumps({"packages": packages}), encoding="utf-8")
        small = root / "node_modules" / "small"
        small.mkdir(parents=True)
        (small / "package.json").write_text('{"name": "small", "version": "1.2.3", "license": "MIT"}', encoding="utf-8")
        if with_license:
            (small / "LICENSE").write_text("text of small", encoding="utf-8")

    def test_only_what_is_bundled(self):
        with tempfile.TemporaryDirectory() as folder:
            self.folder(Path(folder), True)
            _, page, _ = notices(INSTALLED["libz.so.1"], "--headers", "--npm", folder)
        self.assertIn("small 1.2.3, npm package, in the page of drawing_viewer (MIT)", page)
        self.assertIn("text of small", page)
        self.assertNotIn("tool", page.split("=" * 50)[1])

    def test_a_package_without_license_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            self.folder(Path(folder), False)
            code, _, errors = notices(INSTALLED["libz.so.1"], "--headers", "--npm", folder)
        self.assertEqual(code, 1)
        self.assertIn("node_modules/small: no license file", errors)


if __name__ == "__main__":
    unittest.main()
