#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# %% [markdown]
# # A drawing of cameras and images in memory
# As another program would have them: arrays of images, calibrations and poses. Here they come from a COLMAP project:
# `from_memory.py my_project`. An object of pycolmap goes in directly:
# `limn.Scene.from_reconstruction(pycolmap.Reconstruction("my_project/sparse/0"), "my_project/images")`.

# %%
import sys

import numpy as np

import limn

project = limn.open(sys.argv[1], max_image_size=480)
images = [project.image(name) for name in project.names]
K = [camera.K for camera in project.cameras]
R = [camera.R for camera in project.cameras]
t = [camera.t for camera in project.cameras]

# %% [markdown]
# ## Step by step
# Every result keeps what it was made of; options of a stage are given to its function.

# %%
scene = limn.Scene.from_arrays(images, K, R, t, names=project.names, quality="low")
curves = limn.link(scene)
print("curves of", project.names[0], "-", len(curves[project.names[0]]))
sketch = limn.sketch(curves)
print("curves in space:", len(sketch))
rough = limn.draw(sketch)
drawing = limn.refine(rough)
print(rough, "->", drawing)
sigma = np.concatenate([link.sigma for link in drawing.links])
print("median standard deviation:", np.median(sigma[np.isfinite(sigma)]), "units")
