# SPDX-License-Identifier: BSD-3-Clause
"""The program `limn` of a wheel that has it (scripts/packaging/wheels.py)."""

import os
import sys
from pathlib import Path


def main() -> None:
    program = Path(__file__).parent / "bin/limn"
    os.execv(program, [str(program), *sys.argv[1:]])
