#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How well the standard deviations of lengths in a drawing.json predict their errors.

    length_sigmas.py DRAWING JUNCTIONS [--true_frame MOVED] [--radius R] [--pairs 20000]

Nodes of firm links that are the mutually nearest of a true junction, within R (its unit), stand for it; lengths are those
between two of them. MOVED is the same drawing in the frame of the truth, by which nodes are found (to_true_frame.py); lengths
are then scaled by the median of their ratios. Prints JSON: the share of lengths within one and two standard deviations (68 and
95 % if these are right), the factor that they would need, and the same of links whose both ends stand for junctions.
"""

import argparse
import json

import numpy as np
from scipy.spatial import cKDTree


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def covariance_of(node):
    xx, xy, xz, yy, yz, zz = node["covariance"]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def firm_nodes(drawing):
    firm = set()
    for link in drawing["links"]:
        if not link.get("tentative") and link["kind"] not in ("contour", "rod"):
            firm.update((link["node0"], link["node1"]))
    return [n for n in sorted(firm) if "covariance" in drawing["nodes"][n]]


def matches(places, truth, radius):
    """Pairs of indices that are each other's nearest."""
    distances, nearest = cKDTree(truth).query(places, distance_upper_bound=radius)
    _, back = cKDTree(places).query(truth)
    return [(i, nearest[i]) for i in range(len(places)) if np.isfinite(distances[i]) and back[nearest[i]] == i]


def judged(lengths):
    """lengths: rows of (measured, true, sigma)."""
    if len(lengths) < 10:
        return {"lengths": len(lengths)}
    measured, true, sigma = np.array(lengths).T
    ratio = np.abs(measured - true) / sigma
    return {"lengths": len(lengths), "within_1": round(float(np.mean(ratio <= 1)), 3), "within_2": round(float(np.mean(ratio <= 2)), 3),
            "needed_factor": round(float(np.quantile(ratio, 0.683)), 2), "median_sigma": float(np.median(sigma)),
            "median_error": float(np.median(np.abs(measured - true)))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawing")
    parser.add_argument("junctions")
    parser.add_argument("--true_frame")
    parser.add_argument("--radius", type=float, default=0.01, help="two pixel footprints")
    parser.add_argument("--pairs", type=int, default=20000)
    arguments = parser.parse_args()
    drawing = read(arguments.drawing)
    moved = read(arguments.true_frame) if arguments.true_frame else drawing
    truth = np.array([junction["position"] for junction in read(arguments.junctions)["junctions"]])
    ids = firm_nodes(drawing)
    found = matches(np.array([moved["nodes"][n]["position"] for n in ids]), truth, arguments.radius)
    true_of = {ids[i]: truth[t] for i, t in found}
    place = {n: np.array(drawing["nodes"][n]["position"]) for n in true_of}
    covariance = {n: covariance_of(drawing["nodes"][n]) for n in true_of}

    def length(a, b):
        way = place[b] - place[a]
        direction = way / np.linalg.norm(way)
        sigma = np.sqrt(direction @ (covariance[a] + covariance[b]) @ direction)
        return [np.linalg.norm(way), np.linalg.norm(true_of[b] - true_of[a]), sigma]

    nodes = sorted(true_of)
    random = np.random.default_rng(1)
    pairs = [random.choice(nodes, 2, replace=False) for _ in range(arguments.pairs)] if len(nodes) > 1 else []
    between = np.array([length(a, b) for a, b in pairs])
    links = [link for link in drawing["links"] if link["node0"] != link["node1"] and {link["node0"], link["node1"]} <= set(nodes)]
    of_links = np.array([length(link["node0"], link["node1"]) for link in links]).reshape(-1, 3)
    scale = float(np.median(between[:, 1] / between[:, 0])) if arguments.true_frame else 1.0
    for rows in (between, of_links):
        rows[:, [0, 2]] *= scale
    print(json.dumps({"nodes": len(nodes), "scale": scale, "between": judged(between), "links": judged(of_links)}))


if __name__ == "__main__":
    main()
