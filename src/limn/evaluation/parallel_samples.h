// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/evaluation/curve_samples.h"

namespace limn {

// Samples that run within 20 degrees of a direction and whose cells come within `radius` of a
// place, ascending, with the squared distances of the cells; `found` is cleared first.
void FindParallel(const CurveSamples& samples, const Eigen::Vector3d& place,
                  const Eigen::Vector3d& direction, double radius,
                  std::vector<SpatialIndex::Neighbor>* found);

}  // namespace limn
