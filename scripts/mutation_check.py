#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that the tests detect small mutations of the core.

The mutations are in scripts/mutations.txt, a block of lines each:

    [name]
    file  curve_smoothing.cc
    old   text that the file has exactly once
    new   text that replaces it, may be empty
    test  program filter

A file is given by the end of its path under src/, only its name if that is unique, so that files may move. White
space in `old` matches any white space. The filter is GoogleTest's; without one all tests of the program run.

The tests must pass without mutations, and every mutant must compile. A test that fails, crashes or takes longer than
--timeout kills the mutant.
"""

import argparse
import collections
import fcntl
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TABLE = ROOT / "scripts/mutations.txt"
TREE = ROOT / "build/mutations/tree"
BUILD = TREE / "build/release"
LOG = ROOT / "build/mutations/last.log"
LOCK = ROOT / "build/mutations/lock"
KEYS = ("file", "old", "new", "test")
# What a mutation leaves unused is no error.
ALLOWED = "".join(f'#pragma GCC diagnostic ignored "-W{name}"\n' for name in (
    "unused-variable", "unused-but-set-variable", "unused-parameter", "unused-but-set-parameter", "unused-function",
    "type-limits"))

Mutation = collections.namedtuple("Mutation", "name file old new program filter")


class TableError(Exception):
    """The table does not fit the code or the tests."""


def read_table(path=TABLE):
    blocks = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        name = re.fullmatch(r"\[(\w+)\]", line)
        if name:
            blocks.append({"name": name[1]})
            continue
        key, _, value = line.partition(" ")
        if key not in KEYS or not blocks or key in blocks[-1]:
            raise TableError(f"{path.name}:{number}: unexpected line: {line}")
        blocks[-1][key] = value.strip()
    mutations = []
    for block in blocks:
        missing = [key for key in KEYS if key not in block]
        if missing:
            raise TableError(f"{block['name']}: no line '{missing[0]}'")
        program, _, test_filter = block["test"].partition(" ")
        mutations.append(Mutation(block["name"], block["file"], block["old"], block["new"], program,
                                  test_filter.strip() or "*"))
    repeated = [name for name, count in collections.Counter(m.name for m in mutations).items() if count > 1]
    if repeated:
        raise TableError(f"{repeated[0]} is in the table twice")
    return mutations


def pattern_of(old):
    return re.compile(r"\s+".join(re.escape(word) for word in old.split()))


def find_file(mutation, tree):
    files = [path for path in sorted((tree / "src").rglob("*"))
             if path.is_file() and f"/{path.relative_to(tree)}".endswith(f"/{mutation.file}")]
    if len(files) != 1:
        raise TableError(f"stale mutation {mutation.name}: {len(files)} files named {mutation.file}"
                         + hint(mutation, tree))
    return files[0]


def hint(mutation, tree):
    """Where else the text is, for whoever updates the table."""
    pattern = pattern_of(mutation.old)
    found = [str(path.relative_to(tree)) for path in sorted((tree / "src").rglob("*"))
             if path.suffix in (".h", ".cc") and pattern.search(path.read_text(encoding="utf-8"))]
    return f"; the text is in {', '.join(found)}" if found else "; the text is in no file"


def mutate(mutation, tree):
    """The mutated file and its text."""
    path = find_file(mutation, tree)
    text = path.read_text(encoding="utf-8")
    found = list(pattern_of(mutation.old).finditer(text))
    if len(found) != 1:
        raise TableError(f"stale mutation {mutation.name}: {path.relative_to(tree)} has its text {len(found)} times"
                         + (hint(mutation, tree) if not found else ""))
    return path, ALLOWED + text[:found[0].start()] + mutation.new + text[found[0].end():]


def write_new(path, data):
    """Writes the file now: ninja builds by times, and they must not go back."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def update_copy():
    """Makes TREE what git would commit of ROOT; files that are the same keep their times."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            check=True, capture_output=True).stdout.decode().split("\0")
    wanted = {name for name in listed if name and (ROOT / name).is_file()}
    for name in wanted:
        source, copy = ROOT / name, TREE / name
        data = source.read_bytes()
        if copy.is_file() and copy.read_bytes() == data:
            continue
        write_new(copy, data)
        copy.chmod(source.stat().st_mode)
    for folder, folders, files in os.walk(TREE):
        if Path(folder) == TREE and "build" in folders:
            folders.remove("build")
        for name in files:
            path = Path(folder) / name
            if str(path.relative_to(TREE)) not in wanted:
                path.unlink()


def run(command, timeout=None):
    """Exit code and output; no exit code after the timeout."""
    with LOG.open("wb") as log:
        try:
            code = subprocess.run(command, cwd=TREE, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                                  timeout=timeout).returncode
        except subprocess.TimeoutExpired:
            code = None
    return code, LOG.read_text(encoding="utf-8", errors="replace")


def tail(output, count=15):
    return "\n".join(output.splitlines()[-count:])


def configure():
    # One file of a module is changed at a time, so files are not compiled in groups.
    code, output = run(["cmake", "--preset", "release", "-DLIMN_WARNINGS_AS_ERRORS=ON", "-DLIMN_UNITY_BUILD=OFF"])
    if code != 0:
        raise TableError(f"the copy cannot be configured:\n{tail(output)}")


def build(programs, jobs):
    return run(["nice", "ninja", "-C", str(BUILD), f"-j{jobs}", *programs])


def path_of(program):
    found = [path for path in BUILD.rglob(program) if path.is_file() and os.access(path, os.X_OK)]
    if len(found) != 1:
        raise TableError(f"{len(found)} programs named {program} in {BUILD}")
    return found[0]


def run_tests(mutation, timeout):
    return run([str(path_of(mutation.program)), f"--gtest_filter={mutation.filter}", "--gtest_fail_fast",
                "--gtest_brief=0"], timeout)


def selects_tests(output):
    """Whether some test was run, and not skipped."""
    return re.search(r"^\[       OK \]", output, re.M) is not None


def check_unmutated(mutations, options):
    """Builds the tests of one program, and returns the mutations whose filters select none."""
    start = time.monotonic()
    program = mutations[0].program
    code, output = build([program], options.jobs)
    if code != 0:
        raise TableError(f"{program} cannot be built without mutations:\n{tail(output)}")
    without = set()
    for test_filter in sorted({m.filter for m in mutations}):
        those = [m for m in mutations if m.filter == test_filter]
        code, output = run_tests(those[0], options.timeout)
        if code != 0:
            raise TableError(f"{program} --gtest_filter={test_filter} fails without mutations, exit code {code}:\n"
                             + tail(output))
        if not selects_tests(output):
            without.update(m.name for m in those)
    print(f"{program}: built and tested without mutations in {time.monotonic() - start:.0f} s", flush=True)
    return without


def check(mutation, options):
    """Whether the mutant is killed, and by what."""
    path, text = mutate(mutation, TREE)
    original = path.read_bytes()
    try:
        write_new(path, text.encode())
        code, output = build([mutation.program], options.jobs)
        if code != 0:
            raise TableError(f"mutation {mutation.name} does not compile:\n{tail(output)}")
        code, output = run_tests(mutation, options.timeout)
    finally:
        write_new(path, original)
    if code is None:
        return True, f"more than {options.timeout:g} s"
    if code == 0:
        return False, ""
    failed = re.search(r"^\[  FAILED  \] ([\w/.]+)", output, re.M)
    return True, failed[1] if failed else f"exit code {code}"


def spread(mutations, count):
    """`count` of them, evenly spread."""
    count = min(count, len(mutations))
    return [mutations[(2 * i + 1) * len(mutations) // (2 * count)] for i in range(count)]


def choose(mutations, options):
    unknown = sorted(set(options.names) - {m.name for m in mutations})
    if unknown:
        raise TableError(f"no such mutation: {', '.join(unknown)}; --list prints them")
    if options.names:
        mutations = [m for m in mutations if m.name in options.names]
    return spread(mutations, options.sample) if options.sample else mutations


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="run these only")
    parser.add_argument("--list", action="store_true", help="print the mutations, one a line")
    parser.add_argument("--stale", action="store_true", help="only check that the texts of the table are in the code")
    parser.add_argument("--sample", type=int, metavar="N", help="run N of them, evenly spread")
    parser.add_argument("--minutes", type=float, metavar="M", help="start no more after M minutes")
    parser.add_argument("--timeout", type=float, default=120, metavar="S", help="seconds for a test (%(default)s)")
    parser.add_argument("--jobs", "-j", type=int, default=os.cpu_count(), metavar="J", help="of ninja (%(default)s)")
    return parser.parse_args()


def find_stale(mutations, tree):
    problems = []
    for mutation in mutations:
        try:
            mutate(mutation, tree)
        except TableError as error:
            problems.append(str(error))
    return problems


def run_all(mutations, options):
    """Names of those that survived, errors of the table, and how many were not run."""
    begin = time.monotonic()
    programs = list(dict.fromkeys(m.program for m in mutations))
    survived, errors, without_test = [], [], {}
    num_run = 0
    for mutation in sorted(mutations, key=lambda m: programs.index(m.program)):
        if options.minutes is not None and time.monotonic() - begin > 60 * options.minutes:
            break
        num_run += 1
        if mutation.program not in without_test:
            those = [m for m in mutations if m.program == mutation.program]
            without_test[mutation.program] = check_unmutated(those, options)
        start = time.monotonic()
        try:
            no_test = mutation.name in without_test[mutation.program]
            killed, how = (False, "no test") if no_test else check(mutation, options)
        except TableError as error:
            errors.append(str(error).splitlines()[0])
            print(f"ERROR     {error}", flush=True)
            continue
        note = f" ({how})" if how else ""
        if not killed:
            survived.append(f"{mutation.name}: {mutation.program} {mutation.filter}{note}")
        print(f"{'killed' if killed else 'SURVIVED':9} {mutation.name} {time.monotonic() - start:.1f} s{note}",
              flush=True)
    return survived, errors, len(mutations) - num_run


def main():
    options = parse_options()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # not before the file at work is as it was
    try:
        mutations = choose(read_table(), options)
        if options.list:
            for m in mutations:
                print(f"{m.name}: {m.file}: {m.old} -> {m.new or '(nothing)'}")
            return 0
        stale = find_stale(mutations, ROOT)
        if stale or options.stale:
            print("\n".join(stale) or f"{len(mutations)} mutations, none stale")
            return 2 if stale else 0
        TREE.mkdir(parents=True, exist_ok=True)
        lock = LOCK.open("w")
        fcntl.flock(lock, fcntl.LOCK_EX)  # another run waits for this one
        update_copy()
        configure()
        survived, errors, not_run = run_all(mutations, options)
    except TableError as error:
        print(error)
        return 2
    killed = len(mutations) - len(survived) - len(errors) - not_run
    print(f"{killed} killed, {len(survived)} survived, {len(errors)} errors, {not_run} not run")
    for line in survived:
        print(f"survived: {line}")
    for line in errors:
        print(f"error: {line}")
    return 2 if errors else 1 if survived else 0


if __name__ == "__main__":
    sys.exit(main())
