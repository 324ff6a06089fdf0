// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

struct StraightLine {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // either way
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  // Length, less where the direction is uncertain.
  double weight = 0;
};

// The straight links (LineOf) among the drawing's curves in space (LinkSelection's default). The
// heaviest kMaxStraightLines, in order. Time n log n.
std::vector<StraightLine> StraightLines(const DrawingGraph& graph);
constexpr size_t kMaxStraightLines = 2000;

}  // namespace limn
