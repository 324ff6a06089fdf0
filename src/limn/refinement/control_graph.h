#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A link as the ids of its control points, first and last included; a closed one returns to the
// first.
struct ControlLink {
  std::vector<int> points;
  std::vector<ViewId> views;  // in which its edgels are sought, ascending
  // Data within this length of either end is ignored, px, because edges are rounded at corners.
  std::array<double, 2> skip_px = {0, 0};

  int NumSegments() const { return static_cast<int>(points.size()) - 1; }
};

// Three neighbors along a curve.
using Bend = std::array<int, 3>;

// The drawing as the unknowns of a fit (ALGORITHM.md 16.1). Links that meet at a node share the
// control point there. Control point n < number of nodes is node n.
struct ControlGraph {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> start;    // position in the drawing
  std::vector<Eigen::Vector3d> tangent;  // unit, of any link through the point
  std::vector<double> footprint;         // world units per px (LinkFootprint)
  // Whether links meet here in different directions, so that there is no direction along which to
  // hold the point.
  std::vector<uint8_t> corner;
  std::vector<ControlLink> links;  // as in the graph
  std::vector<Bend> bends;         // also through smooth nodes
};

// Control points about `spacing_px` apart along every link. Linear time.
ControlGraph MakeControlGraph(const DrawingGraph& graph, const std::vector<View>& views,
                              double spacing_px);

// Vector from control point `first` to `last` of a link, clamped to its ends.
Eigen::Vector3d Chord(const ControlGraph& control, const ControlLink& link, int first, int last);

// Unit tangents from the neighbors along the links.
void UpdateTangents(ControlGraph* control);

// Moves a polyline to new ends: every point by a mean of the motions of both ends, the nearer end
// weighing more.
void FollowEnds(const Eigen::Vector3d& first, const Eigen::Vector3d& last, Polyline3d* points);

// The same for the control points of frozen links, whose nodes have moved since `before`.
void FollowNodes(const std::vector<uint8_t>& frozen, const std::vector<Eigen::Vector3d>& before,
                 ControlGraph* control);

}  // namespace limn
