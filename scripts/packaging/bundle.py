#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""bundle.py <folder> [--search <folder with libraries>]... <program or library>...: makes files that run anywhere.

Copies the shared libraries that the files use, and those that these use, into <folder>, takes symbols out, and changes
the run paths of all so that they find each other wherever the whole is unpacked. Libraries that every system has stay
out: glibc, the run-time libraries of GCC; and MPI, which must be that of the system's mpirun. Copies get names of their
own, `limn_<name>`, so that a process that has loaded another libtbb.so.12 does not mix the two up; patchelf does what
auditwheel does. Prints the copied files, as they were found, one a line.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# As on any system with a glibc that is new enough (glibc_needed).
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|util|resolv|nsl|anl|mvec|stdc\+\+|gcc_s))\.so.*")
# The parts of MPI.
OF_MPI = re.compile(r"lib(mpi|mpi_cxx|open-rte|open-pal|pmix|hwloc|event.*)\.so.*")
PREFIX = "limn_"


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def needed(file):
    return [name for name in run("patchelf", "--print-needed", file).split()
            if not OF_THE_SYSTEM.fullmatch(name) and not OF_MPI.fullmatch(name)]


def folders_of_the_system():
    """Those of the dynamic linker, by its cache: name -> file."""
    lines = run("/sbin/ldconfig", "-p").splitlines()
    found = {}
    for line in lines:
        match = re.fullmatch(r"\s*(\S+) \(libc6,(x86-64|AArch64)[^)]*\) => (\S+)", line)
        if match:
            found.setdefault(match.group(1), Path(match.group(3)))
    return found


def find(name, search, of_the_system, user):
    for folder in search:
        if (folder / name).exists():
            return folder / name
    if name in of_the_system:
        return of_the_system[name]
    raise SystemExit(f"bundle.py: {user} uses {name}, which is not installed")


def closure(files, search):
    """Name of every library that the files use -> its file."""
    of_the_system = folders_of_the_system()
    libraries, todo = {}, list(files)
    while todo:
        file = todo.pop()
        for name in needed(file):
            if name not in libraries:
                libraries[name] = find(name, search, of_the_system, file)
                todo.append(libraries[name])
    return libraries


def redirect(file, names, run_path):
    """Makes a file use the copies, which are in `run_path` as seen from it."""
    before = needed(file)
    replace = [word for name in before if name in names for word in ("--replace-needed", name, PREFIX + name)]
    # In one call patchelf 0.14 exchanges names and run paths.
    if replace:
        run("patchelf", *replace, file)
    run("patchelf", "--set-rpath", run_path, file)
    after = [PREFIX + name if name in names else name for name in before]
    if needed(file) != after or run("patchelf", "--print-rpath", file).strip() != run_path:
        raise SystemExit(f"bundle.py: patchelf has not changed {file} as it was told to")


def bundle(folder, files, search):
    """Returns the files that were copied."""
    folder.mkdir(parents=True, exist_ok=True)
    libraries = closure(files, search)
    for name, file in sorted(libraries.items()):
        copy = folder / (PREFIX + name)
        shutil.copyfile(file.resolve(), copy)
        copy.chmod(0o755)
        run("strip", "--strip-unneeded", copy)
        run("patchelf", "--set-soname", copy.name, copy)
        redirect(copy, libraries, "$ORIGIN")
    for file in files:
        run("strip", "--strip-unneeded", file)
        redirect(file, libraries, "$ORIGIN/" + os.path.relpath(folder, file.parent))
    return [libraries[name] for name in sorted(libraries)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--search", type=Path, action="append", default=[])
    arguments = parser.parse_args()
    for program in ("patchelf", "strip"):
        if not shutil.which(program):
            raise SystemExit(f"bundle.py: {program} is not installed")
    for file in bundle(arguments.folder, arguments.files, arguments.search):
        print(file)


if __name__ == "__main__":
    sys.exit(main())
