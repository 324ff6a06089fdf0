// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/saw_teeth.h"

#include <algorithm>
#include <cmath>

#include "limn/evaluation/quantiles.h"
#include "limn/model/footprint.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kStepPx = 0.5;

// Means over the window of `reach` samples on either side, of fewer near the ends.
Polyline3d RunningMean(const Polyline3d& samples, int reach) {
  Polyline3d sums(samples.size() + 1, Eigen::Vector3d::Zero());
  for (size_t i = 0; i < samples.size(); ++i) sums[i + 1] = sums[i] + samples[i];
  Polyline3d means(samples.size());
  const int last = static_cast<int>(samples.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const int side = std::min({reach, i, last - i});
    means[i] = (sums[i + side + 1] - sums[i - side]) / (2 * side + 1);
  }
  return means;
}

struct Lengths {
  double raw = 0;
  double smoothed = 0;
};

std::optional<Lengths> Smooth(const Polyline3d& curve, const std::vector<View>& views,
                              const SawTeethOptions& options) {
  const double length = Length(curve);
  if (!(length > 0)) return std::nullopt;
  const double footprint = FootprintOfCurve(views, curve);
  if (length < options.window_px * footprint) return std::nullopt;
  // Sums of offsets from the first point: far from the origin digits would be lost.
  Polyline3d samples = ResampleUniform(curve, kStepPx * footprint);
  for (Eigen::Vector3d& sample : samples) sample -= curve.front();
  const int reach = static_cast<int>(std::lround(0.5 * options.window_px / kStepPx));
  const double smoothed = Length(RunningMean(samples, reach));
  if (!(smoothed > 0)) return std::nullopt;
  return Lengths{length, smoothed};
}

}  // namespace

void SawTeethOptions::Check() const { LIMN_CHECK_OPTION(window_px, > 0); }

std::optional<double> LengthOverSmoothed(const Polyline3d& curve, const std::vector<View>& views,
                                         const SawTeethOptions& options) {
  const std::optional<Lengths> lengths = Smooth(curve, views, options);
  if (!lengths) return std::nullopt;
  return lengths->raw / lengths->smoothed;
}

SawTeeth MeasureSawTeeth(const std::vector<Polyline3d>& curves, const std::vector<View>& views,
                         const SawTeethOptions& options) {
  options.Check();
  if (views.empty()) throw InputError("pixel footprints need at least one view");
  std::vector<double> ratios;
  std::vector<WeightedValue> ratio_and_length;
  for (const Polyline3d& curve : curves) {
    const std::optional<Lengths> lengths = Smooth(curve, views, options);
    if (!lengths) continue;
    ratios.push_back(lengths->raw / lengths->smoothed);
    ratio_and_length.emplace_back(ratios.back(), lengths->smoothed);
  }
  SawTeeth teeth;
  teeth.num_curves = static_cast<int>(ratios.size());
  teeth.median = Quantile(ratios, 0.5);
  teeth.p90 = Quantile(ratios, 0.9);
  teeth.median_by_length = WeightedQuantile(ratio_and_length, 0.5);
  teeth.p90_by_length = WeightedQuantile(ratio_and_length, 0.9);
  return teeth;
}

}  // namespace limn
