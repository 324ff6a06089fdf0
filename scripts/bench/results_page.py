#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the page of results from complete quality reports: tables, what is ahead of Limn, and pictures.

    scripts/bench/results_page.py --commit COMMIT --report report.json [--report ...] [--section SECTION.md ...] FOLDER

The sections, which other benchmarks wrote, are appended. Writes FOLDER/RESULTS.md and FOLDER/results/*.png. scripts/reproduce_results.sh calls it.
"""

import argparse
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
import plot_quality  # noqa: E402

OURS = "default drawing"
# The paper's order: each should be ahead of the one before.
ORDER = ["original sketch", "enhanced sketch", "paper drawing", OURS]
SHARES = {"precision": "P", "recall": "R", "f": "F"}
PICTURE_DPI = 80
ROOT = Path(__file__).resolve().parents[2]


def percent(share):
    return "-" if share is None else f"{100 * share:.1f}"


def shares(row):
    return " / ".join(percent(row[key]) for key in SHARES)


def by_box(data_sets):
    """A data set of its own for every box that others are judged in."""
    return [{**data_set, "boxes": [box],
             "name": data_set["name"] + (f", box {box}" if len(data_set["boxes"]) > 1 else "")}
            for data_set in data_sets for box in data_set["boxes"]]


def box_of(data_set):
    return data_set["boxes"][0]


def row_of(run, data_set, tau_index):
    return run["truth"][box_of(data_set)]["rows"][tau_index]


def tau_name(data_set, tau_index):
    unit = " px" if data_set["unit"] == "footprint" else ""
    return f"{data_set['taus'][tau_index]:g}{unit}"


def middle(data_set):
    return len(data_set["taus"]) // 2


def runs_of(data_set, method):
    return [run for run in data_set["runs"] if run["method"] == method]


def default_runs(data_set):
    return [run for run in data_set["runs"] if run["threshold"] is None]


def is_swept(data_set):
    return len(default_runs(data_set)) < len(data_set["runs"])


def f_of(run, data_set, precision):
    """F at the middle tau from the given kind of precision (plot_quality.Panel)."""
    row = row_of(run, data_set, middle(data_set))
    shares_of = row[precision] or 0, row["recall"] or 0
    return 2 * shares_of[0] * shares_of[1] / sum(shares_of) if sum(shares_of) > 0 else 0


def best_run(data_set, method, precision):
    """The run of the method, at any threshold, with the best F."""
    return max(runs_of(data_set, method), key=lambda run: f_of(run, data_set, precision))


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines) + "\n"


def threshold_name(run):
    return "default" if run["threshold"] is None else f"{run['threshold']} {run['threshold_name']}"


def summary(data_sets, precision):
    """F at the middle tau with default options, the best of the sweep, and the order of the best."""
    rows = []
    for data_set in data_sets:
        cells = [data_set["name"], tau_name(data_set, middle(data_set))]
        best = {method: best_run(data_set, method, precision) for method in ORDER}
        f_of_best = {method: f_of(run, data_set, precision) for method, run in best.items()}
        for method in ORDER:
            default = next(run for run in runs_of(data_set, method) if run["threshold"] is None)
            swept = f"({percent(f_of_best[method])}, {threshold_name(best[method])})" if is_swept(data_set) else "(-)"
            cells.append(f"{percent(f_of(default, data_set, precision))} {swept}")
        cells.append("yes" if sorted(ORDER, key=f_of_best.get) == ORDER else "no")
        rows.append(cells)
    return table(["set", "tau", *ORDER, "in this order"], rows)


def ahead_of_ours(data_set):
    """What others with default options, or as stored, have more of, at each tau."""
    ours = next(run for run in default_runs(data_set) if run["method"] == OURS)
    found = []
    for other in [*default_runs(data_set), *data_set["peers"]]:
        parts = []
        for tau_index in range(len(data_set["taus"])):
            mine, theirs = (row_of(run, data_set, tau_index) for run in (ours, other))
            better = [f"{name} {percent(theirs[key])} to {percent(mine[key])}"
                      for key, name in SHARES.items()
                      if None not in (theirs[key], mine[key]) and theirs[key] > mine[key]]
            if better:
                parts.append(f"at {tau_name(data_set, tau_index)} {', '.join(better)}")
        if parts:
            found.append(f"{other['method']} ({'; '.join(parts)})")
    return found


def losses(data_sets):
    lines = []
    for data_set in data_sets:
        ahead = ahead_of_ours(data_set)
        lines.append(f"* {data_set['name']}: {'; '.join(ahead) if ahead else 'nothing'}.\n")
    return "".join(lines) + "\n"


def data_set_table(data_set):
    tau = middle(data_set)
    taus = range(len(data_set["taus"]))
    heads = ["", *(f"P / R / F at {tau_name(data_set, i)}" for i in taus),
             f"P of samples at {tau_name(data_set, tau)}", "junctions P / R",
             "links per true curve", "curves or points", "CPU s"]
    rows = []
    for run in [*default_runs(data_set), *data_set["peers"]]:
        at_tau = row_of(run, data_set, tau)
        per_curve = at_tau["links_per_chain"]
        shape = run["shape"]
        rows.append([run["method"], *(shares(row_of(run, data_set, i)) for i in taus),
                     percent(at_tau["sample_precision"]),
                     f"{percent(at_tau['junction_precision'])} / {percent(at_tau['junction_recall'])}",
                     "-" if per_curve is None else f"{per_curve:.2f}",
                     str(shape["num_links"] or shape["num_points"]),
                     f"{run['cpu_seconds']:.1f}" if "cpu_seconds" in run else "-"])
    ceiling = data_set["ceiling"][box_of(data_set)]
    rows.append(["*what image curves of the photographs at their own size show*",
                 *(f"- / {percent(recall)} / -" for recall in ceiling), *["-"] * 5])
    return table(heads, rows)


def sweep_table(data_set):
    taus = range(len(data_set["taus"]))
    rows = []
    for method in plot_quality.methods_of([data_set]):
        for run in sorted((run for run in runs_of(data_set, method) if run["threshold"] is not None),
                          key=lambda run: run["threshold"]):
            rows.append([method, threshold_name(run),
                         *(shares(row_of(run, data_set, i)) for i in taus)])
    return table(["", "threshold", *(f"P / R / F at {tau_name(data_set, i)}" for i in taus)], rows)


def judged_file(run):
    """Which of the results of its command a method is."""
    return {"original sketch": "curves/sketch.ply", "enhanced sketch": "curves/enhanced-sketch.ply",
            "swept sketch": "curves/swept-sketch.ply"}.get(run["method"], "drawing.json")


def commands(data_set):
    lines = []
    for run in default_runs(data_set):
        arguments = [argument.removeprefix(f"{ROOT}/") for argument in run["arguments"]]
        lines.append(f"* *{run['method']}*: `{judged_file(run)}` of `limn {' '.join(['automatic_drawer', *arguments])}`\n")
    return "".join(lines) + "\n"


HEAD = """# Results

Written by `scripts/reproduce_results.sh` at commit {commit}; do not edit. Precision P is the share of the drawn length that is within tau of the
truth, recall R the share of the true length within tau of the drawing, F their harmonic mean, in percent, inside the box of the data set; px: pixel
footprints. *P of samples* is the paper's definition read literally ([precision and recall](../src/limn/algorithm/evaluation.md#precision-and-recall)): copies of right curves do not
raise it. It depends on the density of points where either side has points instead of curves (PMVS; the truth of the vase). *CPU s*: of the command
without writing its results, which makes sketch and drawing; cameras are taken as they are given. Where the data sets come from:
[datasets/README.md](README.md#the-data-sets-of-the-results). The methods:

"""


def missing(data_sets):
    """Other programs' results that are not there, which have no rows."""
    paths = [Path(path).name for data_set in data_sets for path in data_set["missing_peers"]]
    return f"**Left out**, not there when this was made: {', '.join(paths)}.\n\n" if paths else ""


def distances(of):
    return f"{of['median_px']:.2f} / {of['p90_px']:.2f} ({percent(of['lonely'])})" if of["count"] else "-"


def photographs(data_sets):
    """What views show that were held out, of data sets without truth."""
    text = """## Photographs

There is no truth: one view in ten is held out. *To edgels*: from the curves that its two neighbors show, projected into it, to its linked edgels; *from
edgels*: from these, of fragments of 20 px or more, to the projected curves; px, median / 90 %, at most 10 (the share without any nearer, %). All
methods are measured by the same edgels; [what is measured](../tests/README.md#the-quality-report).

"""
    for data_set in data_sets:
        text += f"**{data_set['name']}**, {data_set['num_views']} views, {data_set['num_held_out']} held out:\n\n"
        text += table(["", "to edgels", "from edgels", "curves", "CPU s"],
                      [[run["method"], distances(run["held_out"]["to_edgels"]), distances(run["held_out"]["from_edgels"]),
                        str(run["shape"]["num_links"]), f"{run['cpu_seconds']:.1f}"] for run in default_runs(data_set)])
    return text


def page(data_sets, commit, pictures):
    text = HEAD.format(commit=commit) + commands(data_sets[0])
    text += ("Swept: the number of supporting views, of the original sketch the total of inliers. Other programs: stored results.\n\n"
             "## F, with default options (best of the sweep, its threshold)\n\n")
    text += summary(by_box(data_sets), "precision")
    text += "The same with the precision of samples:\n\n" + summary(by_box(data_sets), "sample_precision")
    text += missing(data_sets)
    text += "## What is ahead of the default drawing, and in what\n\n" + losses(by_box(data_sets))
    for name, group in plot_quality.groups_of({"sets": data_sets}).items():
        text += f"## {name}\n\n![Precision and recall, {name}](results/{pictures[name].name})\n\n"
        for data_set in by_box(group):
            text += f"**{data_set['name']}**, {data_set['num_views']} views:\n\n"
            text += data_set_table(data_set)
            if is_swept(data_set):
                text += "<details><summary>sweep</summary>\n\n" + sweep_table(data_set) + "</details>\n\n"
    return text


def sets_of(report):
    """The data sets of a report, all with all methods and their default options."""
    try:
        data_sets = json.loads(report.read_text(encoding="utf-8"))["sets"]
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"ERROR: {report}: {error}")
    for data_set in data_sets:
        if data_set is None:
            sys.exit(f"ERROR: {report}: a data set was not measured")
        if not {run["method"] for run in default_runs(data_set)}.issuperset(ORDER):
            sys.exit(f"ERROR: {report}: {data_set['name']}: not all methods were measured")
    return data_sets


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--commit", required=True)
    parser.add_argument("--report", required=True, type=Path, action="append")
    parser.add_argument("--section", type=Path, action="append", default=[])
    parser.add_argument("folder", type=Path)
    arguments = parser.parse_args()
    data_sets = [data_set for report in arguments.report for data_set in sets_of(report)]
    judged = [data_set for data_set in data_sets if data_set["ceiling"]]
    others = [data_set for data_set in data_sets if not data_set["ceiling"]]
    if not judged:
        sys.exit("ERROR: no data set has a truth")
    try:
        sections = [path.read_text(encoding="utf-8").strip() for path in arguments.section]
    except OSError as error:
        sys.exit(f"ERROR: {error}")
    folder = arguments.folder
    (folder / "results").mkdir(exist_ok=True)
    pictures = {}
    for name, group in plot_quality.groups_of({"sets": judged}).items():
        pictures[name] = folder / "results" / f"precision-recall-{name}.png"
        rows = [(box, "precision") for box in group[0]["boxes"]]
        rows.append((group[0]["boxes"][-1], "sample_precision"))
        plot_quality.draw_group(group, rows, pictures[name], PICTURE_DPI)
    text = page(judged, arguments.commit, pictures) + (photographs(others) if others else "")
    (folder / "RESULTS.md").write_text("\n\n".join([text.rstrip(), *sections]) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
