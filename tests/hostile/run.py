#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run limn on hostile cases of all kinds, made by seeded generators: see hostile.py for the rules.

  run.py LIMN                              some cases of every kind
  run.py LIMN --kind output_links --count 500 --seed 7
  run.py LIMN --kind output_links --seed 7 --case 31 --keep     one of them again, with its folder kept

Prints the cases that break a rule; exit code 1 if there are any.
"""

import argparse
import collections
import concurrent.futures
import importlib
import itertools
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

import hostile  # noqa: E402

NOT_KINDS = ('hostile', 'run', 'scene')


def kinds():
    return sorted(path.stem for path in HERE.glob('*.py') if path.stem not in NOT_KINDS and hasattr(
        importlib.import_module(path.stem), 'cases'))


def cases_of(kind, arguments):
    """The generator is asked for all cases up to the one that is wanted: they may depend on each other's count."""
    count = arguments.count if arguments.case is None else max(arguments.count, arguments.case + 1)
    for index, case in enumerate(itertools.islice(importlib.import_module(kind).cases(arguments.seed, count), count)):
        case.kind, case.seed, case.index = kind, arguments.seed, index
        if arguments.case is None or index == arguments.case:
            yield case


def remove(folder):
    subprocess.run(['chmod', '-R', 'u+rwX', folder], check=False, stderr=subprocess.DEVNULL)
    shutil.rmtree(folder, ignore_errors=True)


def judge(case, program, keep):
    """(case, outcome, broken rules)"""
    folder = program.scratch / f'{case.kind}-{case.seed}-{case.index}'
    outcome = hostile.run_case(case, program, folder)
    broken = importlib.import_module(case.kind).check(case, outcome)
    if not keep:
        remove(folder)
    return case, outcome, broken


def tell(case, outcome, broken):
    print(f'{case.label()}: exit code {outcome.code}, {outcome.seconds:.1f} s, {outcome.max_mb} MB')
    for rule in broken:
        print(f'    {rule}')
    words = [line for line in outcome.errors.splitlines() if line] or outcome.warnings()
    for line in words[-3:]:
        print(f'    | {line[:400]!r}')
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('limn', type=pathlib.Path, help='the program')
    parser.add_argument('--kind', action='append', help='one or more of: ' + ', '.join(kinds()))
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--count', type=int, default=20, help='of each kind')
    parser.add_argument('--case', type=int, help='only this one of each kind')
    parser.add_argument('--jobs', type=int, default=1, help='cases at a time')
    parser.add_argument('--scratch', type=pathlib.Path, help='folder for the cases; made anew and removed by default')
    parser.add_argument('--keep', action='store_true', help='keep the folders of cases')
    parser.add_argument('--all', action='store_true', help='print the cases that keep all rules, too')
    arguments = parser.parse_args()
    scratch = arguments.scratch or pathlib.Path(tempfile.mkdtemp(prefix='limn_hostile_'))
    scratch.mkdir(parents=True, exist_ok=True)
    num_cases, num_broken, codes = 0, 0, collections.Counter()
    try:
        program = hostile.Program(arguments.limn, scratch)
        all_cases = itertools.chain.from_iterable(cases_of(kind, arguments) for kind in arguments.kind or kinds())
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for case, outcome, broken in pool.map(lambda case: judge(case, program, arguments.keep), all_cases):
                num_cases, num_broken = num_cases + 1, num_broken + bool(broken)
                codes[outcome.code] += 1
                if broken or arguments.all:
                    tell(case, outcome, broken)
    finally:
        if arguments.keep:
            print(f'kept in {scratch}')
        elif not arguments.scratch:
            remove(scratch)
    told = ', '.join(f'{number} with exit code {code}' for code, number in sorted(codes.items(), key=str))
    print(f'{num_cases} cases ({told}), {num_broken} broke a rule')
    return 1 if num_broken else 0


if __name__ == '__main__':
    sys.exit(main())
