// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace limn {

// Two orthonormal columns that span the plane across a unit tangent, the only directions in which a
// motion of a curve's point can be seen. Right-handed with the tangent as third.
inline Eigen::Matrix<double, 3, 2> TangentFrame(const Eigen::Vector3d& tangent) {
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = tangent.unitOrthogonal();
  across.col(1) = tangent.cross(across.col(0));
  return across;
}

}  // namespace limn
