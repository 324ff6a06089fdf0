// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/util/median.h"

namespace limn {

// The medians of the coordinates: a few points far away do not move it. Linear time.
inline Eigen::Vector3d MedianPoint(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
    median[axis] = Median(std::move(values));
  }
  return median;
}

}  // namespace limn
