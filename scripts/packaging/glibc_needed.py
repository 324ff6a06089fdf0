#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""glibc_needed.py <file or folder>...: prints the oldest glibc, and the oldest libstdc++, that all programs and libraries
there run with, as "GLIBC 2.36" and "GLIBCXX 3.4.30"."""

import re
import subprocess
import sys
from pathlib import Path


def versions_of(file):
    text = subprocess.run(["readelf", "--version-info", "--wide", str(file)], check=True, stdout=subprocess.PIPE, text=True).stdout
    return re.findall(r"Name: (GLIBC|GLIBCXX)_([\d.]+)", text)


def elf_files(paths):
    for path in paths:
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            if file.is_file() and not file.is_symlink():
                with open(file, "rb") as stream:
                    if stream.read(4) == b"\x7fELF":
                        yield file


def glibc_needed(paths):
    newest = {"GLIBC": (2, 0), "GLIBCXX": (3, 4)}
    for file in elf_files(paths):
        for kind, version in versions_of(file):
            newest[kind] = max(newest[kind], tuple(int(part) for part in version.split(".")))
    return newest


if __name__ == "__main__":
    for kind, version in glibc_needed([Path(argument) for argument in sys.argv[1:]]).items():
        print(kind, ".".join(str(part) for part in version))
