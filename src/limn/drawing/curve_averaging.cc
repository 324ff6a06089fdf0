#include "limn/drawing/curve_averaging.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <Eigen/LU>

#include "limn/geometry/polyline.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Samples to either side of the partner in which the closest point is sought.
constexpr int kSearchSamples = 6;
// Partners that are averaged at most, spread evenly over the overlapping curves: more hardly change
// the mean and cost time.
constexpr size_t kMaxPartners = 12;

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

// Where sample s goes, which is on a curve with these overlaps.
Eigen::Vector3d Average(const SampleSet& samples, const std::vector<CurveOverlap>& overlaps, int s,
                        const DrawingOptions& options) {
  const int k = samples.NameOf(s).sample;
  const Eigen::Vector3d& x = samples.position[s];
  const double footprint = samples.footprint[s];
  const Eigen::Matrix<double, 3, 2> across = TangentFrame(samples.tangent[s]);
  // Every estimate is at best known to a tenth of a pixel: none may rule alone.
  const double floor = std::pow(0.1 * footprint, 2);
  const auto weight = [&](int sample) {
    const Eigen::Matrix2d information = across.transpose() * samples.information[sample] * across +
                                        WeakInformation(footprint) * Eigen::Matrix2d::Identity();
    return Eigen::Matrix2d((information.inverse() + floor * Eigen::Matrix2d::Identity()).inverse());
  };
  Eigen::Matrix2d sum = weight(s);
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  const double max_distance = options.merge_distance_px * footprint;
  std::vector<int> partners;
  for (const CurveOverlap& overlap : overlaps) {
    if (overlap.partner[k] >= 0) partners.push_back(overlap.partner[k]);
  }
  const size_t stride = (partners.size() + kMaxPartners - 1) / kMaxPartners;
  for (size_t i = 0; i < partners.size(); i += stride) {
    const auto foot = ClosestNear(samples, partners[i], x);
    if (!foot || (foot->position - x).norm() > 3 * max_distance) continue;
    const Eigen::Vector2d offset = across.transpose() * (foot->position - x);
    const Eigen::Matrix2d w = weight(partners[i]);
    // Distance in units of the better determined direction, so that depth errors do not exclude.
    const double mahalanobis_px = std::sqrt(offset.dot(w * offset) / w.trace()) / footprint;
    if (mahalanobis_px > options.merge_distance_px) continue;
    sum += w;
    right += w * offset;
  }
  return x + across * sum.inverse() * right;
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

// The paper's: the mean of sample s and its closest points on all curves that it overlaps, which
// become its partners. A curve beyond whose end the foot once was is left out from then on, so that
// nothing switches on and off.
Eigen::Vector3d PlainAverage(const SampleSet& samples, int s, std::vector<CurveOverlap>* overlaps) {
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

AveragingResult AverageCurves(const CurveConsistency& network, const DrawingOptions& options,
                              const RunContext& context, SampleSet* samples) {
  const int num_curves = samples->NumCurves();
  std::vector<std::vector<CurveOverlap>> followed;
  if (options.IsPaper()) followed = network.overlaps;
  std::vector<uint8_t> rests(samples->NumSamples(), 0);
  AveragingResult result;
  result.converged = num_curves == 0;
  while (!result.converged && result.rounds < options.max_averaging_rounds) {
    const auto averages = MapItems(context, "averaging", num_curves, [&](size_t c) {
      std::vector<Eigen::Vector3d> of_curve;
      if (network.overlaps[c].empty()) return of_curve;
      for (int s = samples->curve_begin[c]; s < samples->curve_begin[c + 1]; ++s) {
        if (rests[s]) {
          of_curve.push_back(samples->position[s]);
        } else if (options.IsPaper()) {
          of_curve.push_back(PlainAverage(*samples, s, &followed[c]));
        } else {
          of_curve.push_back(Average(*samples, network.overlaps[c], s, options));
        }
      }
      return of_curve;
    });
    result.last_move_px = 0;
    for (int c = 0; c < num_curves; ++c) {
      int s = samples->curve_begin[c];
      for (const Eigen::Vector3d& average : averages[c]) {
        const double move_px = (average - samples->position[s]).norm() / samples->footprint[s];
        result.last_move_px = std::max(result.last_move_px, move_px);
        rests[s] = options.IsPaper() && move_px <= options.averaging_tolerance_px;
        samples->position[s++] = average;
      }
    }
    ++result.rounds;
    result.converged = result.last_move_px <= options.averaging_tolerance_px;
  }
  return result;
}

}  // namespace limn
