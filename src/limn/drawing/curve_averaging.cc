#include "limn/drawing/curve_averaging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/geometry/tangent_frame.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Samples to either side of the partner in which the closest point is sought.
constexpr int kSearchSamples = 6;
// Partners that are averaged at most, spread evenly over the overlapping curves: more hardly change
// the mean and cost time.
constexpr int kMaxPartners = 12;

// Closest point to x on the other curve near `partner`; nothing where the foot is beyond the
// curve's end.
std::optional<Eigen::Vector3d> ClosestNear(const SampleSet& samples, int partner,
                                           const Eigen::Vector3d& x) {
  const int curve = samples.curve_of[partner];
  const int first = std::max(samples.curve_begin[curve], partner - kSearchSamples);
  const int last = std::min(samples.curve_begin[curve + 1] - 1, partner + kSearchSamples);
  double best = std::numeric_limits<double>::infinity();
  std::optional<Eigen::Vector3d> closest;
  for (int s = first; s < last; ++s) {
    const Eigen::Vector3d along = samples.position[s + 1] - samples.position[s];
    const double squared = along.squaredNorm();
    if (!(squared > 0)) continue;
    const double t = (x - samples.position[s]).dot(along) / squared;
    const bool beyond = (t < 0 && s == samples.curve_begin[curve]) ||
                        (t > 1 && s + 2 == samples.curve_begin[curve + 1]);
    const Eigen::Vector3d foot = samples.position[s] + std::clamp(t, 0.0, 1.0) * along;
    const double distance = (x - foot).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    closest = beyond && !samples.origins[curve].closed ? std::nullopt : std::optional(foot);
  }
  return closest;
}

Eigen::Vector3d Average(const SampleSet& samples, const std::vector<CurveOverlap>& overlaps, int s,
                        int k, const DrawingOptions& options) {
  const Eigen::Vector3d& x = samples.position[s];
  const Eigen::Vector3d& tangent = samples.tangent[s];
  const double footprint = samples.footprint[s];
  const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
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
  const int num_partners = static_cast<int>(
      std::count_if(overlaps.begin(), overlaps.end(),
                    [&](const CurveOverlap& overlap) { return overlap.partner[k] >= 0; }));
  const int stride = (num_partners + kMaxPartners - 1) / kMaxPartners;
  int rank = 0;
  for (const CurveOverlap& overlap : overlaps) {
    if (overlap.partner[k] < 0 || rank++ % stride != 0) continue;
    const auto foot = ClosestNear(samples, overlap.partner[k], x);
    if (!foot || (*foot - x).norm() > 3 * max_distance) continue;
    const Eigen::Vector2d offset = across.transpose() * (*foot - x);
    const Eigen::Matrix2d w = weight(overlap.partner[k]);
    // Distance in units of the better determined direction, so that depth errors do not exclude.
    const double mahalanobis_px = std::sqrt(offset.dot(w * offset) / w.trace()) / footprint;
    if (mahalanobis_px > options.merge_distance_px) continue;
    sum += w;
    right += w * offset;
  }
  return x + across * sum.inverse() * right;
}

// Where a curve's samples go in one round.
struct AveragedCurve {
  std::vector<Eigen::Vector3d> position;
  double moved_px = 0;  // by the sample that goes farthest
};

AveragedCurve AverageCurve(const SampleSet& samples, const std::vector<CurveOverlap>& overlaps,
                           int curve, const DrawingOptions& options) {
  AveragedCurve averaged;
  averaged.position.reserve(samples.Size(curve));
  for (int k = 0; k < samples.Size(curve); ++k) {
    const int s = samples.curve_begin[curve] + k;
    averaged.position.push_back(Average(samples, overlaps, s, k, options));
    averaged.moved_px =
        std::max(averaged.moved_px,
                 (averaged.position[k] - samples.position[s]).norm() / samples.footprint[s]);
  }
  return averaged;
}

}  // namespace

int AverageCurves(const CurveConsistency& network, const DrawingOptions& options,
                  const RunContext& context, SampleSet* samples) {
  if (samples->NumCurves() == 0) return 0;
  std::vector<int> overlapping;
  for (int c = 0; c < samples->NumCurves(); ++c) {
    if (!network.overlaps[c].empty()) overlapping.push_back(c);
  }
  for (int round = 1; round <= options.max_averaging_rounds; ++round) {
    const auto averaged = MapItems(context, "averaging", overlapping.size(), [&](size_t i) {
      const int c = overlapping[i];
      return AverageCurve(*samples, network.overlaps[c], c, options);
    });
    bool is_done = true;
    for (size_t i = 0; i < averaged.size(); ++i) {
      std::copy(averaged[i].position.begin(), averaged[i].position.end(),
                samples->position.begin() + samples->curve_begin[overlapping[i]]);
      is_done = is_done && averaged[i].moved_px <= options.averaging_tolerance_px;
    }
    if (is_done) return round;
  }
  return options.max_averaging_rounds;
}

}  // namespace limn
