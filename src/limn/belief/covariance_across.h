// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/angles.h"

namespace limn {

// A view that looks along the curve within this angle does not tell its plane.
constexpr double kMinAngleToCurve = 3 * kDeg;

// Covariance across a curve of a link's point with this standard deviation (the root of the mean
// over both directions), split as the planes and footprints of its supporting views say: singular
// along the unit tangent. Linear in the views.
Eigen::Matrix3d CovarianceAcross(const DrawingLink& link, const Eigen::Vector3d& point_in_world,
                                 const Eigen::Vector3d& tangent, double sigma,
                                 const std::vector<View>& views);

}  // namespace limn
