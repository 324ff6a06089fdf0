// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/formats/dimension_lines.h"

namespace limn {

// How dimensions appear in a picture.
struct DimensionPicture {
  // Nothing where a place is not in the picture.
  std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector3d&)> place_of;
  double px = 1;  // units of the picture in a pixel
  int decimals = 2;
  DimensionText text;
};

// Writes <g id="dimensions"> with a <g id="dimension_<i>"> each: its lines with oblique ticks, and
// its length along them, readable from below or from the right. Dimensions shorter than a pixel in
// the picture, or outside it, are left out. Styled by the picture's style sheet.
void WriteDimensions(const std::vector<DrawingDimension>& dimensions,
                     const DimensionPicture& picture, std::ostream& out);

}  // namespace limn
