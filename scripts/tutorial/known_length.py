#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The longest straight link of a drawing, with its length in whole centimeters of its unit: an example of --known_length."""

import json
import math
import sys


def straight_length(link):
    primitive = link.get("primitive", {})
    return math.dist(primitive["start"], primitive["end"]) if primitive.get("type") == "line" else 0


links = json.load(open(sys.argv[1], encoding="utf-8"))["links"]
longest = max((link for link in links if not link.get("tentative")), key=straight_length)
print(f"link {longest['id']} = {straight_length(longest):.2f} m")
