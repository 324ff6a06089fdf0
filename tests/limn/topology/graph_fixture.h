// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/drawing_graph.h"

namespace limn::testing {

// The node at a place, -1 if there is none.
inline NodeId NodeAtPlace(const DrawingGraph& graph, const Eigen::Vector3d& place,
                          double max_distance = 1e-9) {
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    if ((graph.nodes[n].position_in_world - place).norm() <= max_distance) {
      return static_cast<NodeId>(n);
    }
  }
  return -1;
}

// 0 where there is no node.
inline int DegreeAt(const DrawingGraph& graph, const Eigen::Vector3d& place,
                    double max_distance = 1e-9) {
  const NodeId node = NodeAtPlace(graph, place, max_distance);
  return node < 0 ? 0 : graph.nodes[node].Degree();
}

// A link through these points. Ends at the same place share a node; a link that returns to its
// first point is closed. The sigmas tell the points apart: 1, 2, 3, ...
inline LinkId DrawLink(const Polyline3d& points, const std::vector<ViewId>& views,
                       DrawingGraph* graph) {
  const auto node_at = [&](const Eigen::Vector3d& place) {
    const NodeId known = NodeAtPlace(*graph, place);
    if (known >= 0) return known;
    graph->nodes.emplace_back();
    graph->nodes.back().position_in_world = place;
    return static_cast<NodeId>(graph->nodes.size()) - 1;
  };
  const auto id = static_cast<LinkId>(graph->links.size());
  DrawingLink link;
  link.points_in_world = points;
  for (size_t k = 0; k < points.size(); ++k) link.sigma.push_back(static_cast<double>(k + 1));
  link.node0 = node_at(points.front());
  link.node1 = node_at(points.back());
  link.points_in_world.front() = graph->nodes[link.node0].position_in_world;
  link.points_in_world.back() = graph->nodes[link.node1].position_in_world;
  link.closed = link.node0 == link.node1;
  link.supporting_views = views;
  link.members = {{id, 0, static_cast<int>(points.size())}};
  link.residual_px = 0.1 * (id + 1);
  graph->links.push_back(std::move(link));
  RebuildIncidence(graph);
  return id;
}

inline DrawingGraph GraphOf(const std::vector<Polyline3d>& links) {
  DrawingGraph graph;
  for (const Polyline3d& points : links) DrawLink(points, {}, &graph);
  return graph;
}

// The pairs of link ends that continue each other at a node, without their order.
inline std::set<std::pair<LinkEnd, LinkEnd>> Continuations(const DrawingNode& node) {
  std::set<std::pair<LinkEnd, LinkEnd>> pairs;
  for (const auto& [first, second] : node.continuations) pairs.insert(std::minmax(first, second));
  return pairs;
}
inline std::set<std::pair<LinkEnd, LinkEnd>> ContinuationsAt(const DrawingGraph& graph,
                                                             const Eigen::Vector3d& place) {
  const NodeId node = NodeAtPlace(graph, place);
  return node < 0 ? std::set<std::pair<LinkEnd, LinkEnd>>() : Continuations(graph.nodes[node]);
}

inline void ExpectValid(const DrawingGraph& graph) {
  const std::vector<std::string> broken = Validate(graph);
  EXPECT_TRUE(broken.empty()) << broken.front();
}

// Largest angle, radians, between a part of a polyline and the next one.
inline double SharpestTurn(const Polyline3d& points) {
  double sharpest = 0;
  for (size_t k = 2; k < points.size(); ++k) {
    const Eigen::Vector3d before = (points[k - 1] - points[k - 2]).normalized();
    const Eigen::Vector3d after = (points[k] - points[k - 1]).normalized();
    sharpest = std::max(sharpest, std::acos(std::clamp(before.dot(after), -1.0, 1.0)));
  }
  return sharpest;
}

}  // namespace limn::testing
