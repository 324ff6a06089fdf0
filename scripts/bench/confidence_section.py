# SPDX-License-Identifier: BSD-3-Clause
"""What false_confidence.py found, as a section of datasets/RESULTS.md."""

from collections import Counter

HEAD = """## False confidence

Written by `scripts/bench/false_confidence.py` with {version}: does a run warn where cameras are wrong, and only there? Scenes of {size} px without
points, drawn with default options: flat and repetitive pictures (paintings, stripes, checkers, windows), from an arc, from anywhere and with a long
lens, and sets with all, most of them also with every second and some with nine of their views. *Exchanged*: pictures with each other's names, mirrored, or one for all; or nothing tells where the
cameras are (equal steps along stripes, cameras that hardly move). *Parts moved*: half of the cameras turned by 1 or 2 degrees, moved by .02 of their
distance, scaled by 1.05, every second turned and moved a little, or 10 % farther. *Warned*: a WARNING or the verdict "nonsense"; *mended*: no warning,
and cameras off by at most twice what right ones of the same scene are off by after refinement. *Failed*: no drawing.

"""
FLAT = ("art-", "stripes-", "checkers-", "windows-")


def group_of(scene):
    kind = "right" if scene.is_right else "parts moved" if scene.base else "exchanged"
    return kind, "flat and repetitive pictures" if scene.name.startswith(FLAT) else "sets"


def section(version, image_size, outcomes):
    """The counts of (scene, outcome), and the scenes that were not as they should be."""
    text = HEAD.format(version=version, size=image_size) + "| cameras | scenes | drawn | warned | mended | failed | neither |\n|---|---|---|---|---|---|---|\n"
    for group in sorted({group_of(scene) for scene, _ in outcomes}, reverse=True):
        found = Counter(outcome for scene, outcome in outcomes if group_of(scene) == group)
        mended = str(found["mended"]) if group[0] == "parts moved" else ""
        text += f"| {' | '.join([*group, str(found.total()), str(found['warned']), mended, str(found['failed']), str(found['not warned'])])} |\n"
    failed = [scene.name for scene, outcome in outcomes if outcome == "failed" or scene.is_right == (outcome != "not warned")]
    return text + f"\nWarned though right, failed or missed: {', '.join(failed) or 'none'}.\n"
