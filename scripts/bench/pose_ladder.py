#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws data sets with cameras that are wrong, more and more, as they are given and refined, and with larger and smaller
images, and compares with exact cameras.

    pose_ladder.py --limn LIMN --pose_noise POSE_NOISE --output_path FOLDER [--sets room] [--errors 0,1] [--seeds 1,2]

Errors are px (tests/bench/pose_noise.cc), `turned` for a camera turned by 5 degrees, models that a set has beside the exact
one, what COLMAP makes of the photographs (`colmap-SIMPLE_RADIAL`), or `scale-2`: images enlarged twice; exact cameras always
are the first row. Every run leaves its figures in FOLDER/<set>/<error>-<seed>/; runs of the same commit are not repeated.
FOLDER/ladder.md and ladder.csv have what was asked for. scripts/pose_ladder.sh builds and calls it.
"""

import argparse
import csv
import json
import shutil
from pathlib import Path

from colmap_model import reconstruct
from measured_run import CommandFailed, Run, main

ROOT = Path(__file__).resolve().parents[2]
SAMPLE_SETS = ["sample-day", "sample-mixed"]  # in this repository
DATA_SETS = ["room", "pavilion-midday", "pavilion-mixed", "vase", "abc-00000952", "abc-00004926", "bench", "herz-jesu-p8"]
FOLDERS = {"pavilion-midday": "pavilion/midday", "pavilion-mixed": "pavilion/mixed"}
EXACT = "0"
PX_ERRORS = ["0.5", "3"]  # as structure from motion leaves them, rough
SCALES = {"scale-0.5": 0.5, "scale-2": 2}
TURNED, TURNED_DEG = "turned", 5
COLMAP = {f"colmap-{model}": model for model in ("SIMPLE_PINHOLE", "SIMPLE_RADIAL")}
GIVEN_MODELS = {"bench": ["sparse-sfm", "sparse-rough"]}
ERRORS = {"herz-jesu-p8": [*COLMAP], **{name: [*models, *SCALES] for name, models in GIVEN_MODELS.items()}}
CAMERA_KEYS = ["num_images", "center", "rotation_px", "rotation_deg", "ray_px", "focal", "num_wrong"]
CSV_KEYS = ["set", "error", "seed", "refine_cameras", "commit", "failure", "unit", "tau_1", "f_1", "tau_2", "f_2", "links",
            *CAMERA_KEYS, "refined", "cpu_seconds", "seconds", "peak_mb"]


def is_px(error):
    return error.replace(".", "", 1).isdigit()


def is_random(error):
    return error == TURNED or (is_px(error) and error != EXACT)


def errors_of(name, asked):
    """Exact cameras, and what was asked for that the set has; by default those of ERRORS, or px."""
    known = GIVEN_MODELS.get(name, [])
    errors = asked or ERRORS.get(name, [*PX_ERRORS, *SCALES])
    return [EXACT, *(error for error in errors if is_random(error) or error in (*COLMAP, *SCALES, *known))]


def cases_of(name, arguments):
    """(error, seed); what is not random has one seed."""
    return [(error, seed) for error in errors_of(name, arguments.errors) for seed in arguments.seeds
            if is_random(error) or seed == arguments.seeds[0]]


def ways_of(error):
    """Values of --refine_cameras."""
    return ["auto"] if error in (EXACT, *SCALES) else ["0", "auto"]


def make_workspace(arguments, name, error, seed, folder):
    command = [arguments.pose_noise, "--set", name, "--data_path", arguments.data_path, "--output_path", folder]
    if error in COLMAP:
        Run([*command, "--error_px", 0])  # for the images
        return Run([*command, "--given_model", reconstruct(folder / "images", COLMAP[error], folder.parent / "colmap")])
    if error in SCALES:
        from degraded_images import replace_images  # needs OpenCV
        shutil.rmtree(folder, ignore_errors=True)
        Run([*command, "--scale", SCALES[error]])
        return replace_images(folder, SCALES[error])
    if error == TURNED:
        return Run([*command, "--turned_deg", TURNED_DEG, "--seed", seed])
    return Run([*command, "--error_px", error, "--seed", seed] if is_px(error) else [*command, "--given_model", f"{error}/0"])


def figures_of(evaluation):
    """What the tables show of a report of drawing_evaluator."""
    rows, cameras = evaluation["rows"], evaluation["cameras"]
    figures = {"unit": evaluation["unit"], "links": evaluation["num_links"]}
    for i, row in enumerate(rows[:2], start=1):
        figures[f"tau_{i}"], figures[f"f_{i}"] = row["tau"], row["f"]
    return {**figures, **{key: cameras[key] for key in CAMERA_KEYS}}


def draw(limn, workspace, refine_cameras, folder):
    """Costs and figures of a drawing, which is not kept: only its evaluation, log and refined cameras."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    try:
        run = Run([limn, "automatic_drawer", "--workspace_path", workspace, "--output_path", folder / "drawing",
                   "--page", 0, "--refine_cameras", refine_cameras])
        (folder / "log.txt").write_text(run.output, encoding="utf-8")
        Run([limn, "drawing_evaluator", "--project_path", workspace / "evaluator.ini", "--input_path",
             folder / "drawing/drawing.json", "--output_json", folder / "evaluation.json"])
    except CommandFailed as failure:
        return {"failure": str(failure)}
    figures = figures_of(json.loads((folder / "evaluation.json").read_text(encoding="utf-8")))
    refined = folder / "drawing/refined"
    figures["refined"] = refined.exists()
    if refined.exists():
        shutil.move(refined, folder / "refined")
    shutil.rmtree(folder / "drawing")
    return {**figures, "cpu_seconds": run.cpu_seconds, "seconds": run.seconds, "peak_mb": run.peak_mb}


def stored(path, commit):
    """The result of an earlier run of this commit, or None."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return result if result.get("commit") == commit else None


def run_case(arguments, commit, name, error, seed):
    """The results of a case, one per value of --refine_cameras."""
    folder = arguments.output_path / name / f"{error}-{seed}"
    workspace = folder / "workspace"
    results = []
    for way in ways_of(error):
        path = folder / f"refine-{way}.json"
        result = stored(path, commit)
        if not result:
            make_workspace(arguments, name, error, seed, workspace)
            result = {"set": name, "error": error, "seed": seed, "refine_cameras": way, "commit": commit,
                      **draw(arguments.limn, workspace, way, folder / f"refine-{way}")}
            path.write_text(json.dumps(result, indent=1), encoding="utf-8")
            print(f"{name} {error} seed {seed} refine_cameras {way}: " + result.get("failure", f"F {percent(result.get('f_1'))}"),
                  flush=True)
        results.append(result)
    return results


def percent(share, digits=1):
    return "-" if share is None else f"{100 * share:.{digits}f}"


def short(number):
    return "-" if number is None else f"{number:.3g}"


def table_row(runs, exact):
    """The ways beside each other, and F of the last relative to exact cameras."""
    error, last = runs[0]["error"], runs[-1]
    relative = percent(last["f_1"] / exact["f_1"]) if last.get("f_1") is not None and exact.get("f_1") else "-"

    def cell(key, text_of):
        return " / ".join(text_of(run.get(key)) for run in runs)
    return [f"{error} px" if is_px(error) else error, str(runs[0]["seed"]), cell("f_1", percent), cell("f_2", percent), relative,
            cell("center", short), cell("rotation_px", short), cell("ray_px", short),
            cell("focal", lambda share: percent(share, 3)), cell("refined", lambda refined: "yes" if refined else "no"),
            cell("links", lambda number: "-" if number is None else str(number)), cell("cpu_seconds", short)]


def markdown(cases):
    """A table per set of the results of cases, the first of which has exact cameras."""
    text = ""
    for name in dict.fromkeys(runs[0]["set"] for runs in cases):
        of_set = [runs for runs in cases if runs[0]["set"] == name]
        exact = of_set[0][0]
        unit = " px" if exact.get("unit") == "footprint" else ""
        heads = ["cameras off by", "seed", *(f"F at {short(exact.get(f'tau_{i}'))}{unit}" for i in (1, 2)), "of exact, %",
                 "centers off", "rotations, px", "rays, px", "focal lengths, %", "refined", "links", "CPU s"]
        lines = [heads, ["---"] * len(heads), *(table_row(runs, exact) for runs in of_set)]
        text += f"**{name}**\n\n" + "".join(f"| {' | '.join(line)} |\n" for line in lines) + "\n"
    return text


HEAD = """## Wrong cameras

Written by `scripts/pose_ladder.sh` at {commit}. Cells: drawn with `--refine_cameras 0` / `auto`; where there is one figure, with `auto`. Cameras are
off in their rotations about the x and y axes and their centers along each axis by that many px (standard deviation); or they are a model that the set
has, or what COLMAP makes of the photographs with one camera of a model (herz-jesu-p8: against cameras from LIDAR). `scale-2`: images enlarged twice.
All is judged in the frame of the true cameras (`drawing_evaluator --true_model_path`), where centers (unit of the model), rotations, rays through the
same pixels and focal lengths are off by what the table says, in the median; F at other sizes is within the same distances. *Of exact*: F of the last way, relative to drawing the
set as it is; *refined*: whether cameras were changed.

"""


def write_tables(folder, commit, cases):
    (folder / "ladder.md").write_text(HEAD.format(commit=commit) + markdown(cases), encoding="utf-8")
    with open(folder / "ladder.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, CSV_KEYS, restval="", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(result for runs in cases for result in runs)


def parsed():
    def words(text):
        return [word for word in text.split(",") if word]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limn", required=True)
    parser.add_argument("--pose_noise", required=True)
    parser.add_argument("--output_path", required=True, type=Path)
    parser.add_argument("--data_path", default=ROOT.parent / "shared/data", type=Path)
    parser.add_argument("--sets", type=words, default=[], help="by default the sample and all data sets that are there")
    parser.add_argument("--errors", type=words, default=[], help="px, turned, a set's own models, or " + ", ".join((*COLMAP, *SCALES)))
    parser.add_argument("--seeds", type=words, default=["1"])
    arguments = parser.parse_args()
    known = [TURNED, *COLMAP, *SCALES, *sum(GIVEN_MODELS.values(), [])]
    for error in arguments.errors:
        if not is_px(error) and error not in known:
            parser.error(f"--errors: {error}: must be a number of px or among {', '.join(known)}")
    arguments.sets = arguments.sets or SAMPLE_SETS + [name for name in DATA_SETS if (arguments.data_path / FOLDERS.get(name, name)).is_dir()]
    return arguments


def body():
    arguments = parsed()
    commit = Run([arguments.limn, "--version"]).output.splitlines()[0]
    cases = []
    for name in arguments.sets:
        for error, seed in cases_of(name, arguments):
            cases.append(run_case(arguments, commit, name, error, seed))
            write_tables(arguments.output_path, commit, cases)
    print(f"Written: {arguments.output_path}/ladder.md, ladder.csv")


if __name__ == "__main__":
    main(body)
