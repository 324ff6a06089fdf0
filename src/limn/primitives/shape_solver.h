// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <ceres/ceres.h>

#include "limn/primitives/link_samples.h"

namespace limn {

// Internal to the fits of shape_fit.h.

// The weighted root of a sample's metric.
inline Eigen::Matrix3d Root(const LinkSample3d& sample) {
  return std::sqrt(sample.weight) * sample.across;
}

void SolveShape(ceres::Problem* problem, int max_iterations);

}  // namespace limn
