# SPDX-License-Identifier: BSD-3-Clause
"""Visibility in the scene by ray casting. Runs inside Blender (mathutils' bounding volume hierarchy)."""

import numpy as np
from mathutils.bvhtree import BVHTree

from mesh import surfaces

NO_HIT = np.inf


class RayCaster:
    """All solids and the ground as one triangle soup."""

    def __init__(self, solids):
        self._tree = BVHTree.FromPolygons(*surfaces(solids))

    def distances(self, origins, directions):
        """Distance to the first hit along unit directions; infinity where nothing is hit."""
        result = np.full(len(directions), NO_HIT)
        cast = self._tree.ray_cast
        origins = np.broadcast_to(origins, np.shape(directions))
        for i, (origin, direction) in enumerate(zip(origins.tolist(), directions.tolist())):
            distance = cast(origin, direction)[3]
            if distance is not None:
                result[i] = distance
        return result

    def sees(self, viewpoint, points, tolerance):
        """Which points are not hidden from a viewpoint by more than `tolerance` (meters)."""
        offset = points - viewpoint
        distance = np.linalg.norm(offset, axis=1)
        return self.distances(viewpoint, offset / distance[:, None]) >= distance - tolerance
