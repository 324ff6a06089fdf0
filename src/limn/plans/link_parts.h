// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// A drawing made from parts of the links of another: links keep their attributes, ends that are not
// cut their nodes. Positions may change on the way, as in a projection.
class LinkPartsBuilder {
 public:
  // `nodes` at their new places.
  explicit LinkPartsBuilder(std::vector<DrawingNode> nodes);

  // The curve of a part: its points (at least two, of some length), and its shape where known.
  struct Curve {
    Polyline3d points;
    std::optional<CurveShape> shape;
  };
  // A part of a link, with the mean of its sigmas; whether it begins and ends where the link does.
  // Then its ends are moved to the nodes there.
  void Add(const DrawingLink& link, bool has_begin, bool has_end, Curve curve);

  // All parts in the order of the calls, and the nodes that they use.
  DrawingGraph Build() &&;

 private:
  NodeId NewNode(const Eigen::Vector3d& position);

  DrawingGraph graph_;
};

}  // namespace limn
