#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# %% [markdown]
# # A first drawing
# Draws a COLMAP project, looks at the curves and writes them for other programs. Each `# %%` is a cell in editors that
# know notebooks (VS Code, Spyder, Jupyter with jupytext); the file runs as a program, too:
# `first_drawing.py my_project output`.

# %%
import sys
from pathlib import Path

import numpy as np

import limn

workspace, output = map(Path, sys.argv[1:3])
output.mkdir(parents=True, exist_ok=True)

# %% [markdown]
# ## Draw
# `quality="low"` is for a first look. Nothing is written into the project.


# %%
def show(stage, done, total):
    print(f"\r{stage}: {100 * done // max(total, 1)} %\033[K", end="")


drawing = limn.draw(workspace, quality="low", max_image_size=480, progress=show)
print(f"\r\033[K{drawing}")
for warning in drawing.warnings:
    print("WARNING:", warning)

# %% [markdown]
# ## Look at the curves
# Points are numpy arrays in the model's coordinates, without copies.

# %%
longest = max(drawing.links, key=lambda link: link.length)
print(f"longest link: {longest.length:.3f} units, {len(longest)} points, {longest.kind}, "
      f"seen in {len(longest.supporting_views)} images")
if longest.primitive is not None:
    print("it is a", longest.primitive.type)
for kind in ("edge", "paint", "shadow", "unknown"):
    print(f"{kind}: {sum(link.length for link in drawing.links if link.kind == kind):.2f} units")
everything = np.concatenate([link.points for link in drawing.links])
print("from", everything.min(axis=0), "to", everything.max(axis=0))

# %% [markdown]
# ## As a graph
# Which parts hang together?

# %%
try:
    import networkx
except ImportError:
    print("networkx is not installed")
else:
    graph = drawing.to_networkx()
    parts = sorted(networkx.connected_components(graph), key=len, reverse=True)
    print(len(parts), "connected parts; the largest has", len(parts[0]), "nodes")

# %% [markdown]
# ## In a photograph
# `tracks` are polylines in px of the images as used, so that they fit `imshow`.

# %%
try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError:
    print("matplotlib is not installed")
else:
    name = longest.supporting_views[0]
    plt.imshow(drawing.scene.image(name) / 255)
    for link in drawing.links:
        if name in link.supporting_views and name in (tracks := link.tracks):
            plt.plot(*tracks[name].T, linewidth=0.8)
    plt.axis("off")
    plt.savefig(output / "overlay.png", dpi=150, bbox_inches="tight")

# %% [markdown]
# ## For other programs

# %%
drawing.save(output / "drawing.json")
drawing.save(output / "drawing.glb")
limn.export(drawing, output / "drawing.dxf", scale=1000, unit="mm", layers="kind", overwrite=True)
print("written:", *sorted(path.name for path in output.iterdir()))
