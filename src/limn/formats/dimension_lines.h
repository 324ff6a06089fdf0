// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

#include "limn/model/dimension.h"
#include "limn/util/length_unit.h"

namespace limn {

// A dimension as drawn: a line between `from` and `to`, and lines to it from the places that are
// measured, across it. World units.
struct DimensionLines {
  Eigen::Vector3d measured_from = Eigen::Vector3d::Zero();
  Eigen::Vector3d measured_to = Eigen::Vector3d::Zero();
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  // Unit vectors, along the line and across it in the plane of the drawing, away from the places.
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();
  Eigen::Vector3d aside = Eigen::Vector3d::UnitY();
};

// The part of the shift along the line is ignored; without a shift the plane is as upright as it
// can be. Precondition: the places differ.
DimensionLines LinesOf(const DrawingDimension& dimension);

// What is written at a dimension: its length times `per_unit`, then the unit.
struct DimensionText {
  double per_unit = 1;
  LengthUnit unit = LengthUnit::kNone;

  // "2.4 m": three decimals of meters and feet, two of inches and centimeters, one of millimeters;
  // four digits of a length without a unit. With its standard deviation, "2.4 ± 0.003 m" (UTF-8),
  // if that is not 0 or rounded to it.
  std::string Of(double length, double sigma = 0) const;
};

}  // namespace limn
