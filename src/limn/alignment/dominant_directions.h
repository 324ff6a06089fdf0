// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/alignment/straight_lines.h"

namespace limn {

struct DominantDirection {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  // Weighted median deviation of the lines that follow it.
  double deviation_rad = 0;
  // Share of the weight of all lines that follow it.
  double share = 0;
};

// The direction within 45 degrees of `hint` along which many lines are and to which many others are
// perpendicular: the most likely if every line is vertical, horizontal or of any direction. Nothing
// if "of any direction" explains the lines as well. Time: number of lines times that of lines and
// 780 pairs, at most 2780.
std::optional<DominantDirection> FindVertical(const std::vector<StraightLine>& lines,
                                              const Eigen::Vector3d& hint);

// The horizontal direction that most horizontal lines follow or are perpendicular to; of the four,
// the one nearest to `reference`, which is not vertical. Nothing if lines run in all directions.
std::optional<DominantDirection> FindHorizontal(const std::vector<StraightLine>& lines,
                                                const Eigen::Vector3d& up,
                                                const Eigen::Vector3d& reference);

// The height of the lowest level along `up` that holds a part of the horizontal lines, the median
// of these; nothing if no level does. Time n log n.
std::optional<double> FloorHeight(const std::vector<StraightLine>& lines,
                                  const Eigen::Vector3d& up);

}  // namespace limn
