// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <random>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::testing {

// Ten views around the origin; a pixel is about kNoisyDrawingPx large there.
inline constexpr double kNoisyDrawingPx = 0.008;
inline constexpr double kDrawnNoisePx = 0.15;
const std::vector<View>& ViewsOfNoisyDrawing();

// Builds graphs of noisy curves, seen by all these views; the noise changes every 10 px.
class NoisyDrawing {
 public:
  using Curve = std::function<Eigen::Vector3d(double)>;

  NodeId AddNode(const Eigen::Vector3d& position);
  // A curve of about this length from node to node.
  void AddLink(NodeId node0, NodeId node1, const Curve& curve, double length);
  // A curve with nodes of its own at its ends.
  void AddCurve(const Curve& curve, double length);

  // kDrawnNoisePx per axis, world units.
  Eigen::Vector3d Noise();

  DrawingGraph graph();

 private:
  DrawingGraph graph_;
  std::mt19937 random_{5};
};

// A segment as such a curve.
NoisyDrawing::Curve LineCurve(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace limn::testing
