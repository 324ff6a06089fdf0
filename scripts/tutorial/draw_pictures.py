#!/usr/bin/python3
"""draw_pictures.py PROJECT OUT PICTURES: what is not a page: photographs, overlay, sheet and SVG.
draw_pictures.py --shrink OUT PICTURES: the screenshots of pages, as small JPEG files."""

import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np

WIDTH = 900


def write(path, image):
    height = round(image.shape[0] * WIDTH / image.shape[1])
    image = cv2.resize(image, (WIDTH, height), interpolation=cv2.INTER_AREA)
    cv2.imwrite(str(path), image, [cv2.IMWRITE_JPEG_QUALITY, 82])


def photographs(project):
    names = sorted((project / "images").iterdir())
    images = [cv2.imread(str(name)) for name in names[:: max(1, len(names) // 6)][:6]]
    rows = [np.hstack(images[i:i + 3]) for i in (0, 3)]
    return np.vstack(rows)


def sheet(path):
    import ezdxf
    import matplotlib
    matplotlib.use("Agg")
    from ezdxf.addons.drawing import Frontend, RenderContext
    from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
    from matplotlib import pyplot
    document = ezdxf.readfile(path)
    figure = pyplot.figure(figsize=(16.5, 11.7))
    axes = figure.add_axes([0, 0, 1, 1])
    Frontend(RenderContext(document), MatplotlibBackend(axes)).draw_layout(document.layout(), finalize=True)
    figure.savefig(path.with_suffix(".png"), dpi=110)
    return cv2.imread(str(path.with_suffix(".png")))


def svg(path):
    subprocess.run(["rsvg-convert", "--width", "1800", "--background-color", "white", "--output", path.with_suffix(".png"), path], check=True)
    return cv2.imread(str(path.with_suffix(".png")))


if sys.argv[1] == "--shrink":
    out, pictures = map(Path, sys.argv[2:])
    for name in out.glob("[0-9][0-9]-*.png"):
        write(pictures / f"{name.stem}.jpg", cv2.imread(str(name)))
else:
    project, out, pictures = map(Path, sys.argv[1:])
    write(pictures / "01-photographs.jpg", photographs(project))
    write(pictures / "03-overlay.jpg", cv2.imread(str(next((project / "curves" / "overlays").glob("*_00*.png")))))
    write(pictures / "08-plan.jpg", sheet(out / "plan.dxf"))
    write(pictures / "09-view.jpg", svg(out / "view.svg"))
