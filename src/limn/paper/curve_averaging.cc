// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/curve_averaging.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "limn/geometry/polyline.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Samples to either side of the partner in which the closest point is sought.
constexpr int kSearchSamples = 6;

// The closest point of a curve, and the sample before it.
struct Foot {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  int sample = -1;
};

// Closest point to x on the other curve near `partner`; nothing where the foot is beyond the
// curve's end.
std::optional<Foot> ClosestNear(const SampleSet& samples, int partner, const Eigen::Vector3d& x) {
  const int curve = samples.curve_of[partner];
  const int begin = samples.curve_begin[curve];
  const int last = samples.curve_begin[curve + 1] - 1;
  const int near_begin = std::max(begin, partner - kSearchSamples);
  const int near_last = std::min(last, partner + kSearchSamples);
  if (near_begin == near_last) return std::nullopt;
  const PolylinePoint closest =
      ClosestPoint(std::span(samples.position).subspan(near_begin, near_last - near_begin + 1), x);
  const int segment = near_begin + closest.segment;
  const Eigen::Vector3d along = samples.position[segment + 1] - samples.position[segment];
  const double t = (x - samples.position[segment]).dot(along) / along.squaredNorm();
  const bool beyond = (t < 0 && segment == begin) || (t > 1 && segment + 1 == last);
  if (beyond && !samples.origins[curve].closed) return std::nullopt;
  return Foot{closest.position, segment};
}

// Closest point to x that is reached from `partner` along the other curve; nothing beyond its end.
std::optional<Foot> FollowTo(const SampleSet& samples, int partner, const Eigen::Vector3d& x) {
  std::optional<Foot> foot = ClosestNear(samples, partner, x);
  while (foot && foot->sample != partner) {
    partner = foot->sample;
    foot = ClosestNear(samples, partner, x);
  }
  return foot;
}

// The mean of sample s and its closest points on all curves that it overlaps, which become its
// partners. A curve beyond whose end the foot once was is left out from then on, so that nothing
// switches on and off.
Eigen::Vector3d Average(const SampleSet& samples, int s, std::vector<CurveOverlap>* overlaps) {
  const int k = samples.NameOf(s).sample;
  Eigen::Vector3d sum = samples.position[s];
  int count = 1;
  for (CurveOverlap& overlap : *overlaps) {
    int& partner = overlap.partner[k];
    if (partner < 0) continue;
    const auto foot = FollowTo(samples, partner, samples.position[s]);
    partner = foot ? foot->sample : -1;
    if (!foot) continue;
    sum += foot->position;
    ++count;
  }
  return sum / count;
}

}  // namespace

AveragingResult AverageCurves(const CurveConsistency& network, const PaperOptions& options,
                              const RunContext& context, SampleSet* samples) {
  const int num_curves = samples->NumCurves();
  std::vector<std::vector<CurveOverlap>> followed = network.overlaps;
  std::vector<uint8_t> rests(samples->NumSamples(), 0);
  AveragingResult result;
  result.converged = num_curves == 0;
  while (!result.converged && result.rounds < options.max_averaging_rounds) {
    const auto averages = MapItems(context, "averaging", num_curves, [&](size_t c) {
      std::vector<Eigen::Vector3d> of_curve;
      if (network.overlaps[c].empty()) return of_curve;
      for (int s = samples->curve_begin[c]; s < samples->curve_begin[c + 1]; ++s) {
        of_curve.push_back(rests[s] ? samples->position[s] : Average(*samples, s, &followed[c]));
      }
      return of_curve;
    });
    result.last_move_px = 0;
    for (int c = 0; c < num_curves; ++c) {
      int s = samples->curve_begin[c];
      for (const Eigen::Vector3d& average : averages[c]) {
        const double move_px = (average - samples->position[s]).norm() / samples->footprint[s];
        result.last_move_px = std::max(result.last_move_px, move_px);
        rests[s] = move_px <= options.averaging_tolerance_px;
        samples->position[s++] = average;
      }
    }
    ++result.rounds;
    result.converged = result.last_move_px <= options.averaging_tolerance_px;
  }
  return result;
}

}  // namespace limn
