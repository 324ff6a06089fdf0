// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"

namespace limn {

// center + cos(a) major + sin(a) minor for a from begin_rad to end_rad, in the plane z = const;
// major and minor are orthogonal half axes, the longer one first, and run counter-clockwise seen
// from above.
struct EllipticalArc {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d major = Eigen::Vector3d::UnitX();
  Eigen::Vector3d minor = Eigen::Vector3d::UnitY();
  double begin_rad = 0;  // in [0, 2 pi)
  double end_rad = 0;    // in (begin_rad, begin_rad + 2 pi]

  double Ratio() const { return minor.norm() / major.norm(); }
};

// The image of an arc under a linear map to a plane, of which the third row is zero, then a move by
// `offset`. It may run the other way; of a circle it begins at 0.
EllipticalArc ImageOf(const CircularArc& arc, const Eigen::Matrix3d& plane_from_space,
                      const Eigen::Vector3d& offset);

}  // namespace limn
