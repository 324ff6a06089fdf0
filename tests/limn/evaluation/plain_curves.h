// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "limn/model/curve_set.h"

namespace limn::testing {

// A line parallel to the x axis.
inline Polyline3d Line(double x0, double x1, double y = 0, double z = 0) {
  return {{x0, y, z}, {x1, y, z}};
}

inline CurveSet Curves(std::vector<Polyline3d> polylines, std::vector<CurveNode> nodes = {}) {
  return {std::move(polylines), {}, std::move(nodes)};
}

}  // namespace limn::testing
