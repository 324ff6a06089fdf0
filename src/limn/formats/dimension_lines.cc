// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dimension_lines.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/util/number_text.h"

namespace limn {
namespace {

Eigen::Vector3d Across(const Eigen::Vector3d& along, const Eigen::Vector3d& vector) {
  return vector - vector.dot(along) * along;
}

int DecimalsOf(LengthUnit unit, double length) {
  switch (unit) {
    case LengthUnit::kMillimeter:
      return 1;
    case LengthUnit::kCentimeter:
    case LengthUnit::kInch:
      return 2;
    case LengthUnit::kMeter:
    case LengthUnit::kFoot:
      return 3;
    case LengthUnit::kNone:
      break;
  }
  constexpr int kDigits = 4;
  return std::clamp(kDigits - 1 - static_cast<int>(std::floor(std::log10(length))), 0, 15);
}

}  // namespace

DimensionLines LinesOf(const DrawingDimension& dimension) {
  DimensionLines lines;
  lines.measured_from = dimension.from;
  lines.measured_to = dimension.to;
  lines.along = (dimension.to - dimension.from).normalized();
  const Eigen::Vector3d shift = Across(lines.along, dimension.shift);
  const double length = (dimension.to - dimension.from).norm();
  if (shift.norm() > 1e-9 * length) {
    lines.aside = shift.normalized();
  } else {
    const Eigen::Vector3d up = Across(lines.along, Eigen::Vector3d::UnitZ());
    const bool is_upright = up.norm() < 0.01;
    lines.aside = (is_upright ? Across(lines.along, Eigen::Vector3d::UnitX()) : up).normalized();
  }
  lines.from = dimension.from + shift;
  lines.to = dimension.to + shift;
  return lines;
}

std::string DimensionText::Of(double length, double sigma) const {
  const double value = per_unit * length;
  const int decimals = DecimalsOf(unit, value);
  std::string number = RoundedText(value, decimals);
  const std::string spread = RoundedText(per_unit * sigma, decimals);
  if (spread != "0") number += " \u00b1 " + spread;
  return unit == LengthUnit::kNone ? number : number + ' ' + UnitName(unit);
}

}  // namespace limn
