# SPDX-License-Identifier: BSD-3-Clause
"""Measures wall time, CPU time and peak memory of a command by wait4. Imported by the other scripts here."""

import os
import subprocess
import sys
import time


class CommandFailed(Exception):
    """A measured command that did not end well; the text names it and shows its last lines."""


class Run:
    """A command that has ended: `seconds`, `cpu_seconds`, `peak_mb` and what it printed (`output`).

    Processor time is that of all its processes; memory is that of the largest of them.
    """

    def __init__(self, command):
        start = time.monotonic()
        with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True) as process:
            self.output = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds = time.monotonic() - start
        self.cpu_seconds = usage.ru_utime + usage.ru_stime
        self.peak_mb = usage.ru_maxrss / 1024
        if process.returncode != 0:
            last = "\n".join(self.output.splitlines()[-10:])
            raise CommandFailed(f"exit code {process.returncode}: {' '.join(map(str, command))}\n{last}")

    def add_to(self, stage):
        """As one more run of a stage of a report (tests/bench/stage_costs.h)."""
        for key in ("seconds", "cpu_seconds", "peak_mb"):
            stage[key].append(getattr(self, key))


def new_stage(name):
    return {"stage": name, "seconds": [], "cpu_seconds": [], "peak_mb": [], "truth": None}


def warm(folder):
    """Reads all files below a folder, so that times do not tell of the disk."""
    for path, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(path, name), "rb") as file:
                while file.read(1 << 20):
                    pass


def main(body):
    """Runs the body of a script; a failed command is one error, not a traceback."""
    try:
        body()
    except (CommandFailed, OSError) as error:
        sys.exit(f"ERROR: {error}")
