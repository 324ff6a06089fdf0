#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""draw_pictures.py PROJECT OUT PICTURES: what is not a page: photographs, overlay, sheet and SVG.
draw_pictures.py --shrink OUT PICTURES: the screenshots of pages, as small JPEG files."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from pictures import grid, read, svg, write  # noqa: E402


def photographs(project):
    names = sorted((project / "images").iterdir())
    return grid([read(name) for name in names[:: max(1, len(names) // 6)][:6]], columns=3)


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
    return read(path.with_suffix(".png"))


if sys.argv[1] == "--shrink":
    out, pictures = map(Path, sys.argv[2:])
    for name in out.glob("[0-9][0-9]-*.png"):
        write(pictures / f"{name.stem}.jpg", read(name))
else:
    project, out, pictures = map(Path, sys.argv[1:])
    write(pictures / "01-photographs.jpg", photographs(project))
    write(pictures / "03-overlay.jpg", read(next((project / "curves" / "overlays").glob("*_00*.png"))))
    write(pictures / "08-plan.jpg", sheet(out / "plan.dxf"))
    write(pictures / "09-view.jpg", svg(out / "view.svg"))
