// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangulation.h"

#include <cmath>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Planes closer to parallel than this, as a squared sine, define nothing.
constexpr double kMinSquaredSine = 1e-12;

}  // namespace

std::optional<Eigen::Vector3d> TangentFromPlanes(const Eigen::Vector3d& normal_a,
                                                 const Eigen::Vector3d& normal_b) {
  const Eigen::Vector3d direction = normal_a.cross(normal_b);
  const double squared = direction.squaredNorm();
  if (!(squared > kMinSquaredSine * normal_a.squaredNorm() * normal_b.squaredNorm())) {
    return std::nullopt;
  }
  return direction / std::sqrt(squared);
}

}  // namespace limn
