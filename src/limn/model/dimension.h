// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace limn {

// A length that the user asked to have written into the drawing: the distance between two places.
// World units.
struct DrawingDimension {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::UnitX();
  // From the places to where the dimension line is drawn; zero: between the places themselves.
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  // Standard deviation of the length; 0: unknown, or not asked for (MeasureDimensions).
  double sigma = 0;
};

}  // namespace limn
