// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "limn/geometry/polygon2d.h"

namespace limn {

// A value in the plane from those at the corners of a polygon, by mean value coordinates (Hormann
// and Floater, Mean value coordinates for arbitrary planar polygons, 2006): smooth inside, linear
// along the sides, exact for values that are linear. At least three corners, none twice in a row;
// `values` per corner. Time: corners.
double MeanValueAt(std::span<const Eigen::Vector2d> corners, std::span<const double> values,
                   const Eigen::Vector2d& place);

}  // namespace limn
