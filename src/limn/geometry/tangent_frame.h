#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace limn {

// Two unit vectors across a unit tangent, at a right angle to each other, as columns: the plane in
// which a point of a curve can be seen to move. Right-handed with the tangent as third.
inline Eigen::Matrix<double, 3, 2> TangentFrame(const Eigen::Vector3d& tangent) {
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = tangent.unitOrthogonal();
  across.col(1) = tangent.cross(across.col(0));
  return across;
}

}  // namespace limn
