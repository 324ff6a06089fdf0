// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"
#include "limn/geometry/polyline.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_paths.h"

namespace limn {

// What meets at a junction: at a T junction one curve goes on, at a crossing all do.
enum class JunctionKind { kUnknown, kCorner, kTee, kCrossing };

// Where curves end or meet.
struct CurveNode {
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  int degree = 0;  // number of curve ends here
  JunctionKind kind = JunctionKind::kUnknown;
};

// Curves or points of any origin, as read from files and used by evaluation and pictures.
struct CurveSet {
  std::vector<Polyline3d> polylines;
  // Points that belong to no polyline.
  std::vector<Eigen::Vector3d> points;
  // Empty: nodes are where ends of polylines coincide exactly.
  std::vector<CurveNode> nodes;
  // Per polyline, the curve that it is a part of (CurvesOf). Empty: each is a curve of its own.
  std::vector<int> curves = {};
  // Per polyline, whether it is known to be a circle. Empty: polylines have no types.
  std::vector<uint8_t> is_circle = {};
  // Per polyline, the radius of the rod whose center line it is, world units; 0: not known, or no
  // rod. Empty: 0 for all.
  std::vector<double> rod_radii = {};
};

inline bool IsCircle(const DrawingLink& link) {
  if (!link.primitive) return false;
  const auto* arc = std::get_if<CircularArc>(&link.primitive->shape);
  return arc && arc->IsCircle();
}

inline CurveSet ToCurveSet(const DrawingGraph& graph) {
  CurveSet set;
  set.polylines.reserve(graph.links.size());
  for (const DrawingLink& link : graph.links) {
    set.polylines.push_back(link.points_in_world);
    set.is_circle.push_back(IsCircle(link));
    set.rod_radii.push_back(link.rod_radius);
  }
  set.curves = CurvesOf(graph);
  set.nodes.reserve(graph.nodes.size());
  for (const DrawingNode& node : graph.nodes) {
    set.nodes.push_back({node.position_in_world, node.Degree()});
  }
  return set;
}

// A closed curve returns to its first point.
inline CurveSet ToCurveSet(const CurveSketch& sketch) {
  CurveSet set;
  set.polylines.reserve(sketch.curves.size());
  for (const Curve3D& curve : sketch.curves) {
    set.polylines.push_back(curve.points_in_world);
    if (curve.closed && curve.size() > 1) {
      set.polylines.back().push_back(curve.points_in_world.front());
    }
  }
  return set;
}

}  // namespace limn
