# SPDX-License-Identifier: BSD-3-Clause
"""SVG drawings by write_pictures (argument), rendered by rsvg-convert: lines are exactly where the scene projects,
hidden parts are missing, and an XML parser finds every link."""

import math
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SKIPPED = 77  # of ctest
ZOOM = 4
NS = "{http://www.w3.org/2000/svg}"

try:
    import cv2
    import numpy as np
except ImportError:
    cv2 = None


def is_dark(picture):
    return picture < 128


class Pictures(unittest.TestCase):
    folder = None

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        subprocess.run([PROGRAM, cls.temporary.name], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def draw(self, name):
        png = self.folder / f"{name}.png"
        subprocess.run(["rsvg-convert", "--zoom", str(ZOOM), "--background-color", "white", "--output", png,
                        self.folder / f"{name}.svg"], check=True)
        return cv2.imread(str(png), cv2.IMREAD_GRAYSCALE)

    def samples(self, name):
        """Places in the enlarged picture and their states."""
        table = np.loadtxt(self.folder / f"{name}.txt")
        return table[:, :2] * ZOOM - 0.5, table[:, 2]

    def check(self, name, least_hidden):
        picture = self.draw(name)
        places, states = self.samples(name)
        height, width = picture.shape
        # Visible samples lie on the line: half of its width is half a pixel, and it is off by a tenth at most.
        on_line = cv2.distanceTransform(np.uint8(~is_dark(picture)), cv2.DIST_L2, 5)
        pixels = np.round(places).astype(int)
        inside = ((pixels >= 0) & (pixels < (width, height))).all(axis=1)
        self.assertGreater(inside.mean(), 0.99)
        pixels, states = pixels[inside], states[inside]
        distances = on_line[pixels[:, 1], pixels[:, 0]] / ZOOM
        self.assertEqual(distances[states == 0].max(), 0)
        # Hidden ones have no line near, but where another passes.
        drawn = np.full(picture.shape, 255, np.uint8)
        shown = pixels[states != 1]
        drawn[shown[:, 1], shown[:, 0]] = 0
        from_shown = cv2.distanceTransform(drawn, cv2.DIST_L2, 5) / ZOOM
        hidden = pixels[states == 1]
        alone = from_shown[hidden[:, 1], hidden[:, 0]] > 1.5
        self.assertGreaterEqual(alone.sum(), least_hidden)
        self.assertFalse(is_dark(picture)[hidden[alone, 1], hidden[alone, 0]].any())
        # And nothing is drawn farther from the samples than half the width, the tolerance and a subpixel.
        self.assertGreater(is_dark(picture).sum(), 0.8 * ZOOM * ZOOM * self.length(name))
        self.assertLess(from_shown[is_dark(picture)].max(), 0.5 + 0.1 + math.sqrt(2) / ZOOM)

    def length(self, name):
        """Of the visible lines in px, overlaps counted once: pixels of the grid that samples touch, about."""
        places, states = self.samples(name)
        cells = np.unique(np.floor(places[states == 0] / ZOOM).astype(int), axis=0)
        return len(cells) / math.sqrt(2)

    def test_view_through_a_lens(self):
        self.check("view", 0)

    def test_view_with_hidden_parts(self):
        self.check("view-hidden", 100)

    def test_axonometric_sheet(self):
        self.check("sheet", 0)

    def test_axonometric_sheet_with_hidden_parts(self):
        self.check("sheet-hidden", 100)

    def test_xml(self):
        for name, title in (("view", "Drawing"), ("sheet-dashed", 'R&D <"sheet">')):
            root = ElementTree.parse(self.folder / f"{name}.svg").getroot()
            self.assertEqual(root.tag, NS + "svg")
            self.assertEqual(root.findtext(NS + "title"), title)
            groups = {group.get("id"): group for group in root.findall(NS + "g")}
            self.assertEqual([link.get("id") for link in groups["links"]], [f"link_{k}" for k in range(9)])
            classes = [link.get("class") for link in groups["links"]]
            self.assertEqual(classes, ["line"] * 3 + ["circle", "arc", "spline"] + ["polyline"] * 2 + ["line"])
            ids = [element.get("id") for element in root.iter() if element.get("id")]
            self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual(len(groups["junctions"]), 1)
        self.assertEqual([text.text for text in groups["legend"].iter(NS + "text")][0], "1:20")
        hidden = [path for path in root.iter(NS + "path") if path.get("class") == "hidden"]
        self.assertEqual(len(hidden), 1)


if __name__ == "__main__":
    if cv2 is None:
        sys.exit("python3-numpy and python3-opencv are missing")
    if shutil.which("rsvg-convert") is None:
        print("SKIPPED: rsvg-convert (librsvg2-bin) is not installed, SVG drawings are not drawn")
        sys.exit(SKIPPED)
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
