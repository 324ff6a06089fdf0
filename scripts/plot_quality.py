#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plot the precision-recall curves of a quality report.

    scripts/plot_quality.py build/quality/report.json [output folder]

One PNG per plot name of the report's data sets (fixed and mixed light of the pavilion share one):
a column per tau, a row per box. Each method is a line through its swept thresholds; the big mark
is the result with default options; crosses are stored results of other programs. Needs Debian's python3-matplotlib.
"""

import json
import sys
from pathlib import Path
from typing import NamedTuple

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

LINE_STYLES = ["-", "--", ":", "-."]
AXIS_LABELS = {"precision": "precision", "sample_precision": "precision of samples"}
PEER_MARKS = {True: "X", False: "x"}  # first data set of a plot, others
PANEL_INCHES = 4.2
TITLE_INCHES = 0.4
LEGEND_POINTS = 8  # size of its letters


def groups_of(report):
    """Data sets with truth by plot name, in the order of the report."""
    groups = {}
    for data_set in report["sets"]:
        if data_set["ceiling"] is not None:
            groups.setdefault(data_set["plot"], []).append(data_set)
    return groups


def methods_of(data_sets):
    """Names of methods in the order of their first run."""
    return list(dict.fromkeys(run["method"] for data_set in data_sets for run in data_set["runs"]))


def programs_of(data_sets):
    """Names of other programs whose results are stored."""
    return list(dict.fromkeys(peer["method"] for data_set in data_sets
                              for peer in data_set["peers"]))


class Panel(NamedTuple):
    box: str
    tau_index: int
    precision: str  # "precision", or "sample_precision": the paper's, read literally


def recall_and_precision(run, panel):
    """Of a run, or None where there is nothing to take a share of."""
    row = run["truth"][panel.box]["rows"][panel.tau_index]
    if row[panel.precision] is None or row["recall"] is None:
        return None
    return row["recall"], row[panel.precision]


def draw_method(axes, runs, panel, color, style, label):
    swept = [run for run in runs if run["threshold"] is not None]
    points = [recall_and_precision(run, panel)
              for run in sorted(swept, key=lambda run: run["threshold"])]
    points = [point for point in points if point is not None]
    axes.plot([p[0] for p in points], [p[1] for p in points], style, marker=".", color=color,
              label=label)
    for run in runs:
        point = recall_and_precision(run, panel)
        if run["threshold"] is None and point is not None:
            axes.plot(*point, marker="o" if style == "-" else "s", markersize=9, color=color,
                      markerfacecolor="none" if style != "-" else color, linestyle="none")


def short_name(data_set):
    """Of a data set among those of its plot."""
    return data_set["name"].removeprefix(data_set["plot"] + "-")


def draw_peers(axes, data_set, programs, panel, filled):
    for peer in data_set["peers"]:
        point = recall_and_precision(peer, panel)
        if point is not None:
            axes.plot(*point, marker=PEER_MARKS[filled], markersize=8, linestyle="none",
                      color=f"C{5 + programs.index(peer['method'])}",
                      label=f"{peer['method']}, {short_name(data_set)}")


def draw_panel(axes, data_sets, methods, panel):
    programs = programs_of(data_sets)
    for number, data_set in enumerate(data_sets):
        style = LINE_STYLES[number % len(LINE_STYLES)]
        for method in methods:
            runs = [run for run in data_set["runs"] if run["method"] == method]
            draw_method(axes, runs, panel, f"C{methods.index(method)}", style,
                        f"{method}, {short_name(data_set)}")
        draw_peers(axes, data_set, programs, panel, number == 0)
        ceiling = data_set["ceiling"][panel.box][panel.tau_index]
        if ceiling is not None:
            axes.axvline(ceiling, color="0.6", linestyle=style, linewidth=1)
    unit = " px" if data_sets[0]["unit"] == "footprint" else ""
    axes.set(title=f"box {panel.box}, tau {data_sets[0]['taus'][panel.tau_index]:g}{unit}",
             xlabel="recall", ylabel=AXIS_LABELS[panel.precision], xlim=(0, 1.02), ylim=(0, 1.02))
    axes.grid(alpha=0.3)


def draw_group(data_sets, rows, path, dpi=100):
    """`rows`: box and kind of precision of each row of panels."""
    taus, methods = data_sets[0]["taus"], methods_of(data_sets)
    legend_columns = min(3, len(taus))
    num_labels = sum(len(methods) + len(data_set["peers"]) for data_set in data_sets)
    legend_inches = 0.3 + 0.18 * -(-num_labels // legend_columns)
    height = TITLE_INCHES + PANEL_INCHES * len(rows) + legend_inches
    figure, panels = plt.subplots(len(rows), len(taus), squeeze=False,
                                  figsize=(PANEL_INCHES * len(taus), height))
    for (box, precision), of_row in zip(rows, panels):
        for tau_index, axes in enumerate(of_row):
            draw_panel(axes, data_sets, methods, Panel(box, tau_index, precision))
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=legend_columns, frameon=False,
                  fontsize=LEGEND_POINTS)
    is_swept = any(run["threshold"] is not None for data_set in data_sets for run in data_set["runs"])
    of_lines = "lines: support threshold swept; " if is_swept else ""
    figure.suptitle(f"Big marks: default options; {of_lines}crosses: other programs;\n"
                    "gray: what image curves of the photographs at their own size show", y=1 - 0.3 * TITLE_INCHES / height)
    figure.tight_layout(rect=(0, legend_inches / height, 1, 1 - TITLE_INCHES / height))
    figure.savefig(path, dpi=dpi)
    plt.close(figure)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: plot_quality.py report.json [output folder]")
    source = Path(sys.argv[1])
    folder = Path(sys.argv[2]) if len(sys.argv) == 3 else source.parent
    try:
        groups = groups_of(json.loads(source.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"ERROR: {source}: {error}")
    for name, data_sets in groups.items():
        path = folder / f"precision-recall-{name}.png"
        draw_group(data_sets, [(box, "precision") for box in data_sets[0]["boxes"]], path)
        print(path)


if __name__ == "__main__":
    main()
