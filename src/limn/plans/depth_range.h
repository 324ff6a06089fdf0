// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include <Eigen/Core>

#include "limn/geometry/triangle_mesh.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// The part of space between two planes across a direction.
struct DepthRange {
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  // unit
  double near = -std::numeric_limits<double>::infinity();
  double far = std::numeric_limits<double>::infinity();

  double DepthOf(const Eigen::Vector3d& point) const { return forward.dot(point); }
  bool Has(const Eigen::Vector3d& point) const {
    return DepthOf(point) >= near && DepthOf(point) <= far;
  }
};

// The part of a drawing within the range: links, cut where they leave it, and dimensions whose
// places are all inside; without faces, regularities and continuations. Parts of links have their
// attributes and their mean sigma. Linear in points and pieces of splines.
DrawingGraph Clipped(const DrawingGraph& graph, const DepthRange& range);

// Triangles within the range, cut where they leave it; no polygons. Linear time.
TriangleMesh Clipped(const TriangleMesh& mesh, const DepthRange& range);

}  // namespace limn
