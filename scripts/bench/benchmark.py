#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The sample scene as a benchmark: a ladder of inputs that get worse, and what methods make of them.

    benchmark.py inputs [--rungs blur-1,views-8]   makes the inputs: build/benchmark/<rung>/
    benchmark.py score <rung> <curves>             scores a PLY, OBJ or drawing.json that was made of one
    benchmark.py methods [--rungs ...]             draws them by four methods of Limn, as expected numbers: section.md

A rung is a COLMAP workspace: images/, sparse/0 (binary; PINHOLE cameras, without points where the images are not those that
the points are from), evaluator.ini with how it is scored. scripts/benchmark.sh builds what is needed and calls it.
datasets/README.md describes inputs, formats and score.
"""

import argparse
import json
import shutil
from dataclasses import dataclass
from pathlib import Path

from degraded_images import SEED, replace_images
from measured_run import CommandFailed, Run, main

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/release"
OUTPUT = ROOT / "build/benchmark"
LIMN = BUILD / "limn"


@dataclass
class Rung:
    """What is wrong: options of tests/bench/pose_noise, and what happens to the pictures."""

    camera_options: tuple = ()
    blur_px: float = 0
    noise: float = 0  # gray levels
    scale: float = 1


RUNGS = {
    "exact": Rung(),
    "pose-0.5": Rung(("--error_px", 0.5)),
    "pose-1.5": Rung(("--error_px", 1.5)),
    "pose-3": Rung(("--error_px", 3)),
    "blur-1": Rung(blur_px=1),
    "blur-2": Rung(blur_px=2),
    "noise-5": Rung(noise=5),
    "noise-15": Rung(noise=15),
    "views-12": Rung(("--num_views", 12)),
    "views-8": Rung(("--num_views", 8)),
    "scale-0.5": Rung(scale=0.5),
    "scale-2": Rung(scale=2),
}
# Name: options of automatic_drawer, file that is scored. The paper takes cameras as they are.
METHODS = {
    "default drawing": ((), "drawing.json"),
    "paper drawing": (("--project_path", ROOT / "scripts/paper.ini"), "drawing.json"),
    "enhanced sketch of the paper": (("--project_path", ROOT / "scripts/paper.ini"), "curves/enhanced-sketch.ply"),
    "original sketch of the paper": (("--mode", "original", "--refine_cameras", 0), "curves/sketch.ply"),
}


def make_input(name):
    """The workspace of a rung; the same bytes every time."""
    rung, folder = RUNGS[name], OUTPUT / name
    shutil.rmtree(folder, ignore_errors=True)
    Run([BUILD / "tests/bench/pose_noise", "--set", "sample-day", "--seed", SEED, "--scale", rung.scale, *rung.camera_options,
         "--output_path", folder])
    replace_images(folder, rung.scale, rung.blur_px, rung.noise)
    return folder


def score(name, curves):
    """The report of drawing_evaluator."""
    report = OUTPUT / name / "report.json"
    run = Run([LIMN, "drawing_evaluator", "--project_path", OUTPUT / name / "evaluator.ini", "--input_path", curves,
               "--output_json", report])
    return run, json.loads(report.read_text(encoding="utf-8"))


def draw_all(name):
    """Method -> its row at 2 px, or why there is none. What two methods share is made once."""
    rows, drawn = {}, {}
    for method, (options, file) in METHODS.items():
        folder = OUTPUT / name / f"drawn-{len(drawn)}"
        try:
            if options not in drawn:
                shutil.rmtree(folder, ignore_errors=True)
                run = Run([LIMN, "automatic_drawer", "--workspace_path", OUTPUT / name, "--output_path", folder, "--page", 0, *options])
                drawn[options] = folder, run.cpu_seconds
            folder, cpu_seconds = drawn[options]
            _, report = score(name, folder / file)
            row = report["rows"][1]  # at 2 px of `exact`
            shares = " / ".join("-" if row[key] is None else f"{100 * row[key]:.1f}" for key in ("precision", "recall", "f"))
            rows[method] = f"{shares} ({cpu_seconds:.0f} s)"
        except CommandFailed as failure:
            rows[method] = "none: " + str(failure).splitlines()[-1]
    return rows


SECTION = """## The benchmark

Written by `scripts/benchmark.sh methods` at {version}. Cells: precision / recall / F at 2 pixel footprints, in percent (footprints of `exact`), and
CPU seconds of the run; the two methods of `scripts/paper.ini` share one. The default refines the cameras, the paper's methods take them as they are.
What the rungs are: [datasets/README.md](README.md#as-a-benchmark).

"""


def write_section():
    """Of all rungs that were drawn, in this call or before."""
    stored = {name: OUTPUT / name / "rows.json" for name in RUNGS}
    results = {name: json.loads(path.read_text(encoding="utf-8")) for name, path in stored.items() if path.exists()}
    version = Run([LIMN, "--version"]).output.splitlines()[0]
    lines = ["| rung | " + " | ".join(METHODS) + " |", "|---" * (len(METHODS) + 1) + "|"]
    lines += [f"| `{name}` | " + " | ".join(rows[method] for method in METHODS) + " |" for name, rows in results.items()]
    (OUTPUT / "section.md").write_text(SECTION.format(version=version) + "\n".join(lines) + "\n", encoding="utf-8")


def rungs_of(text):
    names = text.split(",") if text else list(RUNGS)
    unknown = [name for name in names if name not in RUNGS]
    if unknown:
        raise argparse.ArgumentTypeError(f"{unknown[0]}: must be of {', '.join(RUNGS)}")
    return names


def body():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    tasks = parser.add_subparsers(dest="task", required=True)
    for task in ("inputs", "methods"):
        tasks.add_parser(task).add_argument("--rungs", type=rungs_of, default=list(RUNGS))
    scored = tasks.add_parser("score")
    scored.add_argument("rung", choices=RUNGS)
    scored.add_argument("curves", type=Path)
    arguments = parser.parse_args()
    if arguments.task == "score":
        print(score(arguments.rung, arguments.curves)[0].output, end="")
        return
    for name in arguments.rungs:
        folder = make_input(name)
        print(f"made {folder}", flush=True)
        if arguments.task == "methods":
            rows = draw_all(name)
            (folder / "rows.json").write_text(json.dumps(rows), encoding="utf-8")
            write_section()
            print(f"{name}: {rows}", flush=True)


main(body)
