// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limn {

// Per point, the smallest index of a point at exactly the same position. O(n log n).
std::vector<int> WeldPoints(const std::vector<Eigen::Vector3d>& points);

}  // namespace limn
