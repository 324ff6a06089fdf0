// SPDX-License-Identifier: BSD-3-Clause
#include "support/noisy_drawing.h"

#include <algorithm>
#include <utility>

#include "support/random_numbers.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

const std::vector<View>& ViewsOfNoisyDrawing() {
  static const std::vector<View> views = DomeViews(10, 5);
  return views;
}

NodeId NoisyDrawing::AddNode(const Eigen::Vector3d& position) {
  graph_.nodes.emplace_back();
  graph_.nodes.back().position_in_world = position;
  return static_cast<NodeId>(graph_.nodes.size()) - 1;
}

void NoisyDrawing::AddLink(NodeId node0, NodeId node1, const Curve& curve, double length) {
  const int count = std::max(3, static_cast<int>(length / kNoisyDrawingPx));
  DrawingLink link;
  Eigen::Vector3d noise = Noise();
  Eigen::Vector3d next = Noise();
  for (int k = 0; k <= count; ++k) {
    if (k % 10 == 0) noise = std::exchange(next, Noise());
    const double part = (k % 10) / 10.0;
    link.points_in_world.push_back(curve(static_cast<double>(k) / count) + (1 - part) * noise +
                                   part * next);
  }
  link.node0 = node0;
  link.node1 = node1;
  link.points_in_world.front() = graph_.nodes[node0].position_in_world;
  link.points_in_world.back() = graph_.nodes[node1].position_in_world;
  link.sigma.assign(link.points_in_world.size(), kDrawnNoisePx * kNoisyDrawingPx);
  for (size_t v = 0; v < ViewsOfNoisyDrawing().size(); ++v) {
    link.supporting_views.push_back(static_cast<ViewId>(v));
  }
  graph_.links.push_back(std::move(link));
}

void NoisyDrawing::AddCurve(const Curve& curve, double length) {
  const NodeId node0 = AddNode(curve(0));
  const bool closed = (curve(1) - curve(0)).norm() < 1e-9;
  AddLink(node0, closed ? node0 : AddNode(curve(1)), curve, length);
}

Eigen::Vector3d NoisyDrawing::Noise() {
  testing::NormalDistribution<double> normal(0, kDrawnNoisePx * kNoisyDrawingPx);
  return {normal(random_), normal(random_), normal(random_)};
}

DrawingGraph NoisyDrawing::graph() {
  RebuildIncidence(&graph_);
  for (DrawingLink& link : graph_.links) {
    link.closed = link.node0 == link.node1 && graph_.nodes[link.node0].Degree() == 2;
  }
  RebuildIncidence(&graph_);
  return graph_;
}

NoisyDrawing::Curve LineCurve(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return [=](double t) -> Eigen::Vector3d { return (1 - t) * from + t * to; };
}

}  // namespace limn::testing
