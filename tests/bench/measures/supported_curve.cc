// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/supported_curve.h"

#include <set>

#include "limn/model/curve_set.h"

namespace limn {

std::vector<SupportedCurve> ToSupportedCurves(const DrawingGraph& graph) {
  std::vector<SupportedCurve> curves;
  for (const DrawingLink& link : graph.links) {
    curves.push_back({link.points_in_world, link.supporting_views});
  }
  return curves;
}

std::vector<SupportedCurve> ToSupportedCurves(const CurveSketch& sketch) {
  std::vector<SupportedCurve> curves;
  CurveSet set = ToCurveSet(sketch);
  for (Polyline3d& polyline : set.polylines) {
    std::set<ViewId> views;
    for (const EdgelRef& edgel : sketch.curves[curves.size()].support.edgels) {
      views.insert(edgel.view);
    }
    curves.push_back({std::move(polyline), {views.begin(), views.end()}});
  }
  return curves;
}

}  // namespace limn
