#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes THIRD_PARTY_NOTICES.txt for an archive or wheel that bundles libraries of Debian:

    third_party_notices.py --users build/release/limn --npm build/release/src/limn/viewer/page --output NOTICES FILES...

FILES are shared libraries, as installed or copied from Debian, or folders that hold them. --users are our own programs and modules, which are
not listed, only named as dependents. --npm is a folder with package.json and node_modules: what its page bundles. Headers
that are compiled in (--headers names other packages) are listed, too.

The page starts with a summary: libraries under the LGPL, and under the GPL, with what needs them. A library under the GPL, or one
that may be and that nobody has looked at (reviewed_licenses.txt), is an error, exit code 1: then all that is linked to it may
be passed on only under the GPL. With --gpl accept the page says so instead. The page is written in both cases."""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import debian_licenses  # noqa: E402

# Packages of headers that src/ and colmap_ext/ include and that leave code in our libraries. tinygltf is compiled without stb_image.
HEADERS = ("libboost1.74-dev", "libeigen3-dev", "libflann-dev", "libtinygltf-dev", "nlohmann-json3-dev")
# Compiled into the Python module only.
PYTHON_HEADERS = ("pybind11-dev",)
RULE = "=" * 100 + "\n"
TITLES = {
    "gpl": "Under the GNU GPL",
    "lgpl": "Under the GNU LGPL: linked dynamically, and may be replaced by other builds of the same interface",
    "mpl": "Under the Mozilla Public License or alike: sources at the address given, not changed",
}


class Package:
    """A Debian package: name, version, source ("name version"), license, and the libraries that are bundled from it."""

    def __init__(self, name, libraries, reviewed):
        fields = "${Version}\t${source:Package}\t${source:Version}"
        shown = subprocess.run(["dpkg-query", "--show", f"--showformat={fields}", name], capture_output=True, text=True, check=False)
        if shown.returncode:
            raise SystemExit(f"{name}: no such Debian package is installed; install it where the notices are written")
        self.name = name
        self.version, self.source, self.source_version = shown.stdout.split("\n")[0].split("\t")
        self.license = debian_licenses.license_of(name, reviewed)
        self.libraries = libraries


def shared_libraries(paths):
    """Files named, and those in folders named that are shared libraries by their name; each file once, sorted by name."""
    found = {}
    for path in map(Path, paths):
        if not path.exists():
            raise SystemExit(f"{path}: no such file or folder")
        files = [path] if path.is_file() else [file for file in path.rglob("*.so*") if re.search(r"\.so(\.\d+)*$", file.name)]
        if not files:
            raise SystemExit(f"{path}: no shared library in this folder")
        for file in files:
            found.setdefault(file.resolve(), file)
    return sorted(found.values(), key=lambda file: file.name)


def dynamic(path):
    """(soname, needed sonames) of a shared library or program."""
    shown = subprocess.run(["readelf", "--dynamic", "--wide", path], capture_output=True, text=True, check=False)
    if shown.returncode or "Dynamic section" not in shown.stdout:
        raise SystemExit(f"{path}: not a shared library or dynamic program (readelf)")
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", shown.stdout)
    soname = re.search(r"\(SONAME\).*\[(.*)\]", shown.stdout)
    return (soname.group(1) if soname else Path(path).name), needed


def original_name(name):
    """A library's name without the hash that auditwheel puts into it: libz-1a2b3c4d.so.1 -> libz.so.1."""
    return re.sub(r"-[0-9a-f]{8}(?=\.so)", "", name)


def owners(paths):
    """Installed file -> the package that owns it, of those that a package owns. Debian's packages name files in /lib or in
    /usr/lib, which are one folder."""
    names = {str(path): path for path in paths}
    names |= {plain.removeprefix("/usr"): path for plain, path in names.items()} | {f"/usr{plain}": path for plain, path in names.items()}
    shown = subprocess.run(["dpkg-query", "--search", *names], capture_output=True, text=True, check=False).stdout
    found = re.findall(r"^(?!diversion)([^\s:,]+)[^/\n]*: (/.*)$", shown, re.M)
    return {names[name]: package for package, name in found if name in names}


def loader_paths():
    """Name of a library -> its installed file, as the loader finds it."""
    shown = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True, check=True).stdout
    return dict(re.findall(r"^\s*(\S+) \(.*?\) => (\S+)$", shown, re.M))


def origins(path, soname, installed):
    """The installed files that a library can be: itself, or what it was copied from, by its name."""
    names = [original_name(name) for name in (Path(path).name, soname)]
    return [Path(path).resolve(), *(Path(installed[name]).resolve() for name in names if name in installed)]


def chains(soname, needs):
    """How a library comes to be bundled: the shortest "a needs b needs c" from each file that nothing needs."""
    users = {}
    for user, needed in needs.items():
        for name in needed:
            users.setdefault(name, []).append(user)
    queue, seen, found = [[soname]], {soname}, []
    for chain in queue:
        above = [user for user in users.get(chain[0], []) if user not in seen]
        if not users.get(chain[0]):
            found.append(" needs ".join(chain))
        seen.update(above)
        queue.extend([user, *chain] for user in above)
    return found


def npm_packages(folder):
    """[(name, version, license, text)] of what a page bundles: the packages of package-lock.json that are not for development."""
    lock = json.loads((Path(folder) / "package-lock.json").read_text(encoding="utf-8"))
    result = []
    for place, entry in sorted(lock["packages"].items()):
        if not place or entry.get("dev"):
            continue
        installed = Path(folder) / place
        files = sorted(file for file in installed.glob("*") if re.match(r"(LICEN[CS]E|COPYING|NOTICE)", file.name, re.I))
        if not files:
            raise SystemExit(f"{installed}: no license file; give --npm the folder of the build, where npm has installed the packages")
        about = json.loads((installed / "package.json").read_text(encoding="utf-8"))
        text = "\n".join(file.read_text(encoding="utf-8") for file in files)
        result.append((about["name"], about["version"], about.get("license", "see its text"), text))
    if not result:
        raise SystemExit(f"{folder}/package-lock.json: names no package that is bundled")
    return result


def summary(packages, needs, accept_gpl):
    """(lines, errors): the libraries by license."""
    lines, errors = [], []
    for kind, title in TITLES.items():
        chosen = [package for package in packages if package.license.kind == kind]
        lines.append(f"{title}: {'none' if not chosen else ''}".rstrip())
        for package in chosen:
            names = ", ".join(package.libraries) or "headers"
            lines.append(f"  {package.name}: {names} ({package.license.name})")
            if kind != "gpl":
                continue
            if package.license.where:
                lines.append(f"    {package.license.where}")
            reasons = [reason for library in package.libraries for reason in chains(library, needs)]
            lines.extend(f"    {reason}" for reason in reasons)
            doubt = "" if package.license.reviewed else (
                ", or so its copyright file can be read: look at it and add a line to reviewed_licenses.txt")
            errors.append(f"{names} ({package.name}) is under the GPL ({package.license.name}){doubt}"
                          + "".join(f"\n    {reason}" for reason in reasons))
        lines.append("")
    if errors and accept_gpl:
        lines.insert(0, "As a whole, with the libraries that are bundled, this work may be passed on only under the GNU General Public License,\n"
                        "version 3 (some libraries are under the Apache License 2.0, which version 2 excludes). Limn's own sources keep their license.\n")
    return lines, errors


def sections(packages):
    """A text per source package: equal copyright files are printed once."""
    by_text = {}
    for package in packages:
        by_text.setdefault(debian_licenses.copyright_text(package.name), []).append(package)
    for text, group in by_text.items():
        first = group[0]
        head = [f"{package.name} {package.version}: {', '.join(package.libraries) or 'headers, compiled in'} ({package.license.name})"
                for package in group]
        head.append(f"Source: Debian's {first.source} {first.source_version}, by apt-get source {first.source}={first.source_version}")
        head.append(f"        or from https://snapshot.debian.org/package/{first.source}/{first.source_version}/")
        yield RULE + "\n".join(head) + "\n\n" + text.strip() + "\n\n"


def page(packages, npm, lines):
    """The whole file."""
    parts = ["Limn is distributed with parts of other people's work. This file has their notices and licenses.\n\n", *(f"{line}\n" for line in lines)]
    for name, version, license_name, text in npm:
        parts.append(f"{RULE}{name} {version}, npm package, in the page of drawing_viewer ({license_name})\n"
                     f"Source: https://www.npmjs.com/package/{name}/v/{version}\n\n{text.strip()}\n\n")
    parts.extend(sections(packages))
    common = sorted({name for package in packages for name in debian_licenses.common_licenses_in(debian_licenses.copyright_text(package.name))})
    for name in common:
        text = (debian_licenses.COMMON / name).read_text(encoding="utf-8")
        parts.append(f"{RULE}/usr/share/common-licenses/{name}, which texts above refer to\n\n{text.strip()}\n\n")
    return "".join(parts)


def bundled_packages(files, headers, reviewed):
    """(packages, needs): of the libraries and of the headers that are compiled in; soname -> sonames that it needs."""
    installed, needs, places = loader_paths(), {}, {}
    for file in files:
        soname, needs_of_file = dynamic(file)
        needs[soname] = needs_of_file
        places[soname] = origins(file, soname, installed)
    owned = owners({place for candidates in places.values() for place in candidates})
    libraries = {name: [] for name in headers}
    for soname, candidates in places.items():
        found = [owned[place] for place in candidates if place in owned]
        if not found:
            raise SystemExit(f"{candidates[0]}: of no Debian package that is installed here; install the one it was copied from, "
                             "or leave the file out")
        libraries.setdefault(found[0], []).append(soname)
    return [Package(name, libraries[name], reviewed) for name in sorted(libraries)], needs


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("libraries", nargs="+", metavar="FILES")
    parser.add_argument("--output", required=True, type=Path)
    parser.add_argument("--users", nargs="*", default=[], type=Path)
    parser.add_argument("--npm", action="append", default=[], type=Path)
    parser.add_argument("--headers", nargs="*", default=list(HEADERS + PYTHON_HEADERS))
    parser.add_argument("--gpl", choices=["refuse", "accept"], default="refuse")
    return parser.parse_args()


def main():
    chosen = options()
    reviewed = debian_licenses.reviewed_licenses()
    packages, needs = bundled_packages(shared_libraries(chosen.libraries), chosen.headers, reviewed)
    for user in chosen.users:
        needs[user.name] = dynamic(user)[1]
    npm = [package for folder in chosen.npm for package in npm_packages(folder)]
    lines, errors = summary(packages, needs, chosen.gpl == "accept")
    chosen.output.write_text(page(packages, npm, lines), encoding="utf-8")
    print(f"{chosen.output}: {sum(len(package.libraries) for package in packages)} libraries of {len(packages)} packages, {len(npm)} npm packages")
    if errors and chosen.gpl == "refuse":
        for error in errors:
            print(f"ERROR: {error}", file=sys.stderr)
        print("To go on: link libraries that are built without these, or leave them to the user's system, or pass the whole on "
              "under the GPL (--gpl accept)", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    os.environ["LC_ALL"] = "C"
    sys.exit(main())
