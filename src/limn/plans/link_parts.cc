// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/link_parts.h"

#include <numeric>
#include <utility>

namespace limn {

LinkPartsBuilder::LinkPartsBuilder(std::vector<DrawingNode> nodes) {
  graph_.nodes = std::move(nodes);
  for (DrawingNode& node : graph_.nodes) node.continuations.clear();
}

void LinkPartsBuilder::Add(const DrawingLink& link, bool has_begin, bool has_end, Curve curve) {
  DrawingLink part = link;
  part.points_in_world = std::move(curve.points);
  part.vertices.clear();
  part.members.clear();
  part.regularity.reset();
  part.closed = link.closed && has_begin && has_end;
  part.node0 = has_begin ? link.node0 : NewNode(part.points_in_world.front());
  part.node1 = has_end ? link.node1 : NewNode(part.points_in_world.back());
  part.points_in_world.front() = graph_.nodes[part.node0].position_in_world;
  part.points_in_world.back() = graph_.nodes[part.node1].position_in_world;
  const double sum = std::accumulate(link.sigma.begin(), link.sigma.end(), 0.0);
  part.sigma.assign(part.points_in_world.size(), sum / static_cast<double>(link.sigma.size()));
  if (curve.shape) {
    LinkPrimitive primitive = link.primitive.value_or(LinkPrimitive());
    primitive.shape = std::move(*curve.shape);
    part.primitive = std::move(primitive);
  } else {
    part.primitive.reset();
  }
  graph_.links.push_back(std::move(part));
}

DrawingGraph LinkPartsBuilder::Build() && {
  const std::vector<uint8_t> keep(graph_.links.size(), 1);
  RebuildIncidence(&graph_);
  RemoveLinks(keep, &graph_);  // also nodes without links
  return std::move(graph_);
}

NodeId LinkPartsBuilder::NewNode(const Eigen::Vector3d& position) {
  graph_.nodes.emplace_back();
  graph_.nodes.back().position_in_world = position;
  return static_cast<NodeId>(graph_.nodes.size()) - 1;
}

}  // namespace limn
