// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/geometry/triangle_mesh.h"

namespace limn {

struct SharpEdgeOptions {
  // The edge of two polygons is sharp if the surface bends there by at least this angle. Lower:
  // also facets of coarsely meshed round surfaces.
  double min_dihedral_deg = 30;
  // Curves end where they turn by more than this at a vertex. Higher: they continue around corners
  // of borders.
  double min_corner_deg = 50;

  // Throws OptionError.
  void Check() const;
};

// The edges of a surface that a picture may show even without paint: where the surface bends, where
// more than two polygons meet, and borders, which have a polygon on one side only. Orientations of
// polygons do not matter. Edges are joined to curves, which end where they turn or where the number
// of such edges is not two; a closed curve without a corner returns to its first point. Throws
// OptionError. O(n log n).
std::vector<Polyline3d> FindSharpEdges(const TriangleMesh& mesh, const SharpEdgeOptions& options);

}  // namespace limn
