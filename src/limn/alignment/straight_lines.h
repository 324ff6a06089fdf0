#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

struct StraightLine {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // either way
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  // Length, reduced as the direction is uncertain.
  double weight = 0;
};

// The straight links of the drawing that are curves of things (LinkSelection's default), see
// LineOf. The heaviest kMaxStraightLines, in order. Time n log n.
std::vector<StraightLine> StraightLines(const DrawingGraph& graph);
constexpr size_t kMaxStraightLines = 2000;

}  // namespace limn
