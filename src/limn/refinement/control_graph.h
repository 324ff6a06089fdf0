#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A link as the ids of its control points, first and last included; a closed one returns to the
// first.
struct ControlLink {
  std::vector<int> points;
  // Data within this length of either end is left out, px: edges are rounded at corners.
  std::array<double, 2> skip_px = {0, 0};

  int NumSegments() const { return static_cast<int>(points.size()) - 1; }
};

// The drawing as the unknowns of a fit: control points, of which those at nodes are shared by the
// links that meet there. Control point n < number of nodes is node n.
struct ControlGraph {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> start;    // where it was in the drawing
  std::vector<Eigen::Vector3d> tangent;  // unit, of any link through the point
  std::vector<double> footprint;         // world units per px, median over the supporting views
  // Links meet here in different directions: nothing holds such a point along one of them.
  std::vector<uint8_t> corner;
  std::vector<ControlLink> links;  // as in the graph
  // Triples of neighbors along a curve, through smooth nodes too.
  std::vector<std::array<int, 3>> bends;
};

// Control points about `spacing_px` apart along every link. Linear time.
ControlGraph MakeControlGraph(const DrawingGraph& graph, const std::vector<View>& views,
                              double spacing_px);

// Unit tangents from the neighbors along the links.
void UpdateTangents(ControlGraph* control);

// Move the inner points of links marked nonzero by what their nodes moved since `before`, the
// nearer node counting more.
void FollowNodes(const std::vector<uint8_t>& frozen, const std::vector<Eigen::Vector3d>& before,
                 ControlGraph* control);

}  // namespace limn
