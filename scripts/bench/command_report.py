#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures commands as a whole and writes a report like that of tests/bench/stage_report.

    command_report.py --output report.json --commit abc123 --name midday COMMAND [ARGUMENT ...]

`{new}` in an argument becomes a fresh folder, which is removed afterwards. Where the command prints the summaries of
`limn automatic_drawer` ("drawing: 1.2 s, peak memory 300 MB"), these become stages with wall time and
the peak memory so far, without CPU time; "total" is the whole process.
"""

import argparse
import json
import re
import tempfile

from measured_run import Run, main, new_stage

SUMMARY = re.compile(r"^([a-z ]+): ([0-9.]+) s, peak memory ([0-9,]+) MB$", re.MULTILINE)


def stages_of(run):
    stages = []
    for name, seconds, peak_mb in SUMMARY.findall(run.output):
        stage = new_stage(name)
        stage["seconds"].append(float(seconds))
        stage["peak_mb"].append(float(peak_mb.replace(",", "")))
        stages.append(stage)
    total = new_stage("total")
    run.add_to(total)
    return stages + [total]


def body():
    parser = argparse.ArgumentParser()
    parser.add_argument("--output", required=True)
    parser.add_argument("--commit", default="")
    parser.add_argument("--name", required=True)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run = Run([word.replace("{new}", folder) for word in arguments.command])
    data_set = {"name": arguments.name, "num_views": None, "unit": "", "taus": [], "stages": stages_of(run)}
    report = {"format": "limn stages 2", "commit": arguments.commit, "threads": -1, "sets": [data_set]}
    with open(arguments.output, "w", encoding="utf-8") as file:
        json.dump(report, file, indent=1)


if __name__ == "__main__":
    main(body)
