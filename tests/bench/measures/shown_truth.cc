// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/shown_truth.h"

#include <algorithm>
#include <cmath>

#include "limn/evaluation/curve_samples.h"
#include "limn/model/footprint.h"
#include "limn/support/edgel_residual.h"
#include "limn/support/view_edgels.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kSpacingPx = 0.5;
constexpr size_t kChunk = 1024;

// `direction` is zero for a point of no curve.
bool IsShown(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, const View& view,
             const EdgelIndex& edgels, const SupportGate& gate) {
  const auto pixel = view.Project(point);
  if (!pixel) return false;
  if (!direction.isZero()) {
    const auto along = ProjectedDirection(view, point, direction);
    return along && edgels.Best(*pixel, *along, gate);
  }
  return edgels.AnyWithin(*pixel, gate.normal_px);
}

}  // namespace

void ShownTruthOptions::Check() const {
  LIMN_CHECK_OPTION(max_distance_px, > 0);
  LIMN_CHECK_OPTION(max_angle_deg, > 0);
  LIMN_CHECK_OPTION(min_views, >= 1);
}

CurveSet ShownTruth(const CurveSet& truth, const std::vector<View>& views,
                    const std::vector<ImageCurves>& curves, const ShownTruthOptions& options,
                    const RunContext& context) {
  options.Check();
  const SupportGate gate{options.max_distance_px, 1.0, options.max_angle_deg * kDeg};
  const auto edgels = BuildViewEdgels(curves, context);
  const CurveSamples samples(truth, [&](const Polyline3d& polyline) {
    return kSpacingPx * FootprintOfCurve(views, polyline);
  });
  const auto count = static_cast<size_t>(samples.size());
  std::vector<uint8_t> shown(count, 0);
  ParallelFor(context, "shown truth", (count + kChunk - 1) / kChunk, [&](size_t chunk) {
    for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      const int sample = static_cast<int>(i);
      const Eigen::Vector3d& point = samples.Position(sample);
      if (options.region && !options.region->contains(point)) continue;
      int num_views = 0;
      for (size_t v = 0; v < views.size() && num_views < options.min_views; ++v) {
        num_views += IsShown(point, samples.Direction(sample), views[v], edgels[v]->edgels, gate);
      }
      shown[i] = num_views >= options.min_views;
    }
  });
  CurveSet set;
  for (size_t i = 0; i < count; ++i) {
    if (shown[i]) set.points.push_back(samples.Position(static_cast<int>(i)));
  }
  return set;
}

}  // namespace limn
