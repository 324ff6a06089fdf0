#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Edits as the page writes them, of a drawing.json: removes the shadows, and gives the two longest level lines dimensions."""

import json
import math
import sys


def reference(link):
    points = link["points"]
    step = max(1, (len(points) - 1) // 15)
    chosen = points[::step][:15] + points[-1:]
    return {"id": link["id"], "closed": link["closed"], "points": chosen}


def dimension(link):
    start, end = link["points"][0], link["points"][-1]
    return {"edit": "dimension", "from": {"link": reference(link), "at": start}, "to": {"link": reference(link), "at": end},
            "shift": [0, 0, 0.1]}


drawing = json.load(open(sys.argv[1], encoding="utf-8"))
firm = [link for link in drawing["links"] if not link.get("tentative")]
shadows = [link for link in firm if link["kind"] == "shadow"]
lines = [link for link in firm if link.get("primitive", {}).get("type") == "line" and link["kind"] == "edge"]
lines = [link for link in lines if abs(link["points"][0][2] - link["points"][-1][2]) < 0.05]
lines.sort(key=lambda link: -math.dist(link["points"][0], link["points"][-1]))
edits = [{"edit": "delete", "links": [reference(link) for link in shadows]}] + [dimension(link) for link in lines[:2]]
with open(sys.argv[2], "w", encoding="utf-8") as file:
    json.dump({"format": "limn_edits", "format_version": 1, "edits": edits}, file)
