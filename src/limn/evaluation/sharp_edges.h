#pragma once

#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/geometry/triangle_mesh.h"

namespace limn {

struct SharpEdgeOptions {
  // Two polygons meet at a sharp edge if their surface bends there by at least this angle. Lower:
  // also the facets of coarsely meshed round surfaces.
  double min_dihedral_deg = 30;
  // Curves end where they turn by more than this at a vertex. Higher: they run around corners of
  // borders.
  double min_corner_deg = 50;

  // Throws OptionError.
  void Check() const;
};

// The edges of a surface that a picture may show, whatever its paint: where two polygons bend,
// where more than two meet, and the border, which has a polygon on one side only. Orientations of
// polygons do not matter. Edges are joined to curves that end where other than two such edges meet
// or where they turn; a closed curve without a corner returns to its first point. Throws
// OptionError. O(n log n).
std::vector<Polyline3d> FindSharpEdges(const TriangleMesh& mesh, const SharpEdgeOptions& options);

}  // namespace limn
