// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"

namespace limn::testing {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline Eigen::AlignedBox3d SlabBetween(double low_x, double high_x) {
  return {Eigen::Vector3d(low_x, -kInfinity, -kInfinity),
          Eigen::Vector3d(high_x, kInfinity, kInfinity)};
}

// A link with nodes of its own; a closed one does not repeat its first point here.
inline LinkId AddLink(Polyline3d points, bool closed, DrawingGraph* graph) {
  DrawingLink link;
  if (closed) points.push_back(points.front());
  const auto add_node = [&](const Eigen::Vector3d& position) {
    graph->nodes.emplace_back();
    graph->nodes.back().position_in_world = position;
    return static_cast<NodeId>(graph->nodes.size()) - 1;
  };
  link.node0 = add_node(points.front());
  link.node1 = closed ? link.node0 : add_node(points.back());
  link.sigma.assign(points.size(), 0.001);
  link.points_in_world = std::move(points);
  link.closed = closed;
  link.supporting_views = {0, 1, 2};
  graph->links.push_back(std::move(link));
  RebuildIncidence(graph);
  return static_cast<LinkId>(graph->links.size()) - 1;
}

inline double LengthOf(const DrawingGraph& graph) {
  double length = 0;
  for (const DrawingLink& link : graph.links) length += Length(link.points_in_world);
  return length;
}

}  // namespace limn::testing
