// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/epipolar.h"

#include <Eigen/LU>

namespace limn {

RelativeProjection MakeRelativeProjection(const PinholeCamera& camera_a,
                                          const Rigid3d& a_from_world,
                                          const PinholeCamera& camera_b,
                                          const Rigid3d& b_from_world) {
  const Rigid3d b_from_a = b_from_world * Inverse(a_from_world);
  const Eigen::Matrix3d calibration = camera_b.Calibration();
  return {calibration * b_from_a.rotation.toRotationMatrix() * camera_a.Calibration().inverse(),
          calibration * b_from_a.translation};
}

}  // namespace limn
