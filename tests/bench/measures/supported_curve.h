// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A curve and the views that it was made from.
struct SupportedCurve {
  Polyline3d points_in_world;
  std::vector<ViewId> supporting_views;  // ascending
};

std::vector<SupportedCurve> ToSupportedCurves(const DrawingGraph& graph);

// A closed curve returns to its first point.
std::vector<SupportedCurve> ToSupportedCurves(const CurveSketch& sketch);

}  // namespace limn
