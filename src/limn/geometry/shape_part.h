// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/geometry/curve_shape.h"

namespace limn {

// The part of a shape between 0 <= t0 < t1 <= 1, exactly. A part of a spline has triple knots where
// the whole has single ones.
CurveShape PartOf(const CurveShape& shape, double t0, double t1);

}  // namespace limn
