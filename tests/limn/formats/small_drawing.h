// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "limn/model/drawing_graph.h"

namespace limn {

// Three links that meet at a junction, two of them smoothly, and one closed link.
inline DrawingGraph SmallDrawing() {
  DrawingGraph graph;
  const auto add_node = [&](double x, double y, double z) {
    DrawingNode node;
    node.position_in_world = {x, y, z};
    graph.nodes.push_back(node);
  };
  const auto add_link = [&](NodeId node0, NodeId node1, std::vector<Eigen::Vector3d> inner) {
    DrawingLink link;
    link.points_in_world = std::move(inner);
    link.points_in_world.insert(link.points_in_world.begin(), graph.nodes[node0].position_in_world);
    link.points_in_world.push_back(graph.nodes[node1].position_in_world);
    link.sigma.assign(link.points_in_world.size(), 0.125);
    link.node0 = node0;
    link.node1 = node1;
    link.closed = node0 == node1;
    link.supporting_views = {0, 1};
    link.members = {{3, 0, 7}, {5, 2, 4}};
    link.residual_px = 0.1;
    graph.links.push_back(link);
  };
  add_node(0, 0, 0);
  add_node(1, 0, 0);
  add_node(-1, 1e-17, 0);
  add_node(0, 0, 1.0 / 3);
  add_node(5, 5, 5);
  add_link(0, 1, {{0.5, 0, 0}});
  add_link(2, 0, {{-0.7, 0, 0}, {-0.3, 0, 0}});
  add_link(0, 3, {});
  add_link(4, 4, {{6, 5, 5}, {6, 6, 5}, {5, 6, 5}});
  graph.links[2].sigma[1] = std::numeric_limits<double>::infinity();
  RebuildIncidence(&graph);
  graph.nodes[0].continuations = {{{0, 0}, {1, 1}}};
  return graph;
}

}  // namespace limn
