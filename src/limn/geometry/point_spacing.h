// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace limn {

// Median distance of a point to its nearest neighbor, over a thousand points spread over the list;
// copies of a point are not neighbors. 0 if no point has a neighbor. O(n log n).
double PointSpacing(const std::vector<Eigen::Vector3d>& points);

}  // namespace limn
