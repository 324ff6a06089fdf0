// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/formats/svg/path.h"
#include "limn/formats/svg/sheet.h"
#include "limn/geometry/curve_shape.h"

namespace limn {

// Both append curves to a path, each after a move to its start.

// Appends FitBeziers of the points. A polyline without length becomes a dot.
void AppendFitted(const std::vector<Eigen::Vector2d>& points, double tolerance, SvgPath* path);

// Appends the part of a shape between 0 <= t0 < t1 <= 1, exactly; an arc whose ellipse is narrower
// than `tolerance` becomes a line.
void AppendShape(const SvgSheet& sheet, const CurveShape& shape, double t0, double t1,
                 double tolerance, SvgPath* path);

}  // namespace limn
