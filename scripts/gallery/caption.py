#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""caption.py SET DRAWING.json CPU_SECONDS: a line with what a caption says of a drawing."""

import json
import sys

name, path, seconds = sys.argv[1:]
with open(path, encoding="utf-8") as file:
    drawing = json.load(file)
firm = sum(not link.get("tentative") for link in drawing["links"])
print(f"{name}: {len(drawing['views'])} photographs, {firm:,} links and {len(drawing['links']) - firm:,} tentative ones, {float(seconds):.0f} CPU s")
