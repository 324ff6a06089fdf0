#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that every header compiles in a file that includes nothing else.

    scripts/check_headers.py build/release

Each header of src/limn and colmap_ext is compiled with -fsyntax-only and the flags of its folder from
compile_commands.json of the build folder. Headers whose source file is not part of the build (STEP files
without OpenCASCADE) are skipped.

Eigen would take most of the time. It is precompiled, and used only for headers that include it
themselves or through another header of the project, so that it hides no missing include. The
standard library and the project's own precompiled headers are never used.

A header that passed is not compiled again until it, a header that it includes, the flags or the compiler
change; headers/passed.json in the build folder records those that passed.
"""

import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
# The first that a header reaches is precompiled for it. Geometry includes Core.
PRECOMPILED = ["Eigen/Geometry", "Eigen/Core"]
# Flags that take the next word with them and are of no use here.
DROPPED_WITH_VALUE = {"-o", "-include", "-MF", "-MT", "-MQ"}
DROPPED = {"-c", "-MD", "-MMD", "-Winvalid-pch"}


class Closure:
    """What a header includes, directly or through other headers of the project."""

    def __init__(self):
        self.text = {}

    def read(self, path):
        if path not in self.text:
            self.text[path] = path.read_text(encoding="utf-8")
        return self.text[path]

    def of(self, header):
        """Files of the project and names in angle brackets."""
        files, names, waiting = {header}, set(), [header]
        while waiting:
            path = waiting.pop()
            for bracket, target in INCLUDE.findall(self.read(path)):
                if bracket == "<":
                    names.add(target)
                    continue
                for folder in (ROOT / "src", ROOT, path.parent):
                    file = folder / target
                    if file.exists():
                        if file not in files:
                            files.add(file)
                            waiting.append(file)
                        break
        return files, names


def sources_of(file):
    """The file, or those that CMake has put into one to compile them together (LIMN_UNITY_BUILD)."""
    if file.parent.name != "Unity":
        return [file]
    return [Path(name) for name in re.findall(r'^#include "(.+)"$', file.read_text(encoding="utf-8"), re.M)]


def flags_of(command):
    """Compiler and flags of an entry of compile_commands.json."""
    words = shlex.split(command["command"])
    # A launcher such as ccache may stand in front.
    while words and Path(words[0]).name in ("ccache", "sccache", "distcc"):
        words.pop(0)
    flags, skip = [], False
    for word in words[1:]:
        if skip:
            skip = False
        elif word in DROPPED_WITH_VALUE:
            skip = True
        elif word not in DROPPED and not word.endswith((".cc", ".cpp")) and not re.match(r"-O|-g", word):
            flags.append(word)
    return words[0], flags


def run(command):
    return subprocess.run(command, capture_output=True, text=True, cwd=ROOT)


def shared_flags(flags, macros):
    """The flags that Eigen is precompiled with: all but places, and of macros those that all folders have.

    The compiler accepts a precompiled header only if all flags that matter to it are the same; a macro
    that is defined for one folder only must not be defined in it.
    """
    result = []
    for word in flags:
        place = word == "-isystem" or not word.startswith("-") or word.startswith("-I")
        if not place and (not word.startswith("-D") or word in macros):
            result.append(word)
    return tuple(result)


def precompile(folder, compiler, shared, places, name):
    """Returns the header to include instead of <name>."""
    key = hashlib.sha256(" ".join([compiler, *shared, *places]).encode()).hexdigest()[:12]
    header = folder / f"{name.replace('/', '_')}_{key}.h"
    header.write_text(f"#include <{name}>\n", encoding="utf-8")
    done = run([compiler, *shared, *places, "-x", "c++-header", str(header), "-o", f"{header}.gch"])
    if done.returncode != 0:
        sys.exit(f"{name} does not compile:\n{done.stderr}")
    return header


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve()
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    folder = build / "headers"
    folder.mkdir(exist_ok=True)
    built = {source for command in commands for source in sources_of(Path(command["file"]))}
    of_folder = {}
    for command in commands:
        for source in sources_of(Path(command["file"])):
            of_folder.setdefault(source.parent, flags_of(command))

    closure, work, left_out, version = Closure(), [], [], {}
    headers = sorted(file for top in ("src/limn", "colmap_ext") for file in (ROOT / top).rglob("*.h"))
    for header in headers:
        name = header.relative_to(ROOT).as_posix()
        source = header.with_suffix(".cc")
        if header.parent not in of_folder or (source.exists() and source not in built):
            left_out.append(name)
            continue
        compiler, flags = of_folder[header.parent]
        if compiler not in version:
            version[compiler] = run([compiler, "--version"]).stdout
        files, names = closure.of(header)
        digest = hashlib.sha256()
        for part in [version[compiler], *flags, *(closure.read(file) for file in sorted(files))]:
            digest.update(part.encode() + b"\0")
        eigen = next((name for name in PRECOMPILED if name in names), None)
        work.append((name, compiler, flags, eigen, digest.hexdigest()))

    kept = folder / "passed.json"
    passed = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else {}
    todo = [item for item in work if passed.get(item[0]) != item[4]]

    macros = set.intersection(*({word for word in flags if word.startswith("-D")} for _, flags in of_folder.values()))
    precompiled = {}
    for _, compiler, flags, eigen, _ in todo:
        key = (compiler, shared_flags(flags, macros), eigen)
        if eigen and key not in precompiled:
            places = [word for pair in zip(flags, flags[1:]) if pair[0] == "-isystem" for word in pair]
            precompiled[key] = precompile(folder, *key[:2], places, eigen)

    def check(item):
        name, compiler, flags, eigen, _ = item
        # Twice: a header that defines something needs a guard.
        text = f'#include "{ROOT / name}"\n' * 2
        source = folder / (name.replace("/", "_") + ".cc")
        source.write_text(text, encoding="utf-8")
        key = (compiler, shared_flags(flags, macros), eigen)
        first = ["-include", str(precompiled[key])] if eigen else []
        return run([compiler, *flags, *first, "-fsyntax-only", str(source)])

    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for item, done in zip(todo, pool.map(check, todo)):
            if done.returncode == 0:
                passed[item[0]] = item[4]
                continue
            failed += 1
            print(f"{item[0]} does not compile alone:\n{done.stderr}")
    kept.write_text(json.dumps(passed, indent=0, sort_keys=True), encoding="utf-8")
    for name in left_out:
        print(f"{name}: left out, not part of this build")
    print(f"{len(headers)} headers, {len(todo)} compiled, {failed} do not compile alone")
    return 1 if failed or not work else 0


if __name__ == "__main__":
    sys.exit(main())
