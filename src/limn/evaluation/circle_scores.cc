// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/circle_scores.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "limn/evaluation/parallel_samples.h"
#include "limn/geometry/circle_through.h"

namespace limn {
namespace {

constexpr double kMaxDeviation = 0.01;  // over the radius
// Fewer turn by more than 40 degrees at each: corners (true_chains.h).
constexpr size_t kMinVertices = 9;
constexpr double kMinCoveredShare = 0.9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<double> kRadiiInFootprints = {0, 4, 6, 10, 16, 30, kInfinity};
const std::vector<double> kRadiiInWorld = {0, kInfinity};

bool IsClosed(const Polyline3d& points) {
  return points.size() > 2 && points.front() == points.back();
}

std::optional<CircularArc> FindCircle(const Polyline3d& points) {
  if (!IsClosed(points) || points.size() <= kMinVertices) return std::nullopt;
  const auto circle = CircleThrough(points);
  const auto is_on_circle = [&](const Eigen::Vector3d& point) {
    return DistanceFromCircle(*circle, point) <= kMaxDeviation * circle->radius;
  };
  return circle && std::ranges::all_of(points, is_on_circle) ? circle : std::nullopt;
}

// How many of the samples of a circle are covered: by anything, and by each link and curve.
struct CircleCover {
  int num_samples = 0;
  int num_covered = 0;
  std::map<int, int> by_link, by_curve;

  bool IsMost(int num) const { return num > kMinCoveredShare * num_samples; }
};

void AddSample(const SampledScene& sampled, int sample, CircleCover* cover) {
  const Eigen::Vector3d& position = sampled.truth.Position(sample);
  const std::vector<int>& curves = sampled.scene.reconstruction.curves;
  std::vector<SpatialIndex::Neighbor> found;
  FindParallel(sampled.reconstruction, position, sampled.truth.Direction(sample),
               sampled.Radius(1, position), &found);
  std::set<int> links_here, curves_here;
  for (const SpatialIndex::Neighbor& drawn : found) {
    const int link = sampled.reconstruction.CurveOf(drawn.index);
    links_here.insert(link);
    curves_here.insert(curves.empty() ? link : curves[link]);
  }
  ++cover->num_samples;
  cover->num_covered += !found.empty();
  for (const int link : links_here) ++cover->by_link[link];
  for (const int curve : curves_here) ++cover->by_curve[curve];
}

void AddCircle(const SampledScene& sampled, const CircleCover& cover, CircleScores* scores) {
  const CurveSet& drawn = sampled.scene.reconstruction;
  bool is_closed = false;
  bool is_of_type = false;
  for (const auto& [link, num] : cover.by_link) {
    if (!cover.IsMost(num) || !IsClosed(drawn.polylines[link])) continue;
    is_closed = true;
    is_of_type = is_of_type || (!drawn.is_circle.empty() && drawn.is_circle[link]);
  }
  ++scores->num_circles;
  scores->covered += static_cast<double>(cover.num_covered) / cover.num_samples;
  scores->num_one_curve += std::ranges::any_of(
      cover.by_curve, [&](const auto& curve) { return cover.IsMost(curve.second); });
  scores->num_closed += is_closed;
  if (scores->num_of_type_circle) *scores->num_of_type_circle += is_of_type;
}

std::vector<CircleScores> EmptyBins(const SampledScene& sampled) {
  const auto& radii = sampled.scene.in_footprints ? kRadiiInFootprints : kRadiiInWorld;
  std::vector<CircleScores> bins(radii.size() - 1);
  for (size_t i = 0; i < bins.size(); ++i) {
    bins[i].from = radii[i];
    bins[i].to = radii[i + 1];
    if (!sampled.scene.reconstruction.is_circle.empty()) bins[i].num_of_type_circle = 0;
  }
  return bins;
}

}  // namespace

std::vector<CircleScores> ScoreCircles(const SampledScene& sampled) {
  const CurveSamples& truth = sampled.truth;
  std::vector<CircleScores> bins = EmptyBins(sampled);
  for (int begin = 0, end = 0; begin < truth.size(); begin = end) {
    end = begin + 1;
    while (!truth.IsLast(end - 1)) ++end;
    const auto circle = FindCircle(sampled.scene.truth.polylines[truth.CurveOf(begin)]);
    if (!circle) continue;
    CircleCover cover;
    bool is_inside = true;
    for (int i = begin; i < end && is_inside; ++i) {
      is_inside = sampled.scene.InRegion(truth.Position(i));
      if (is_inside) AddSample(sampled, i, &cover);
    }
    if (!is_inside) continue;
    const double radius = circle->radius / sampled.scene.unit_at(circle->center);
    for (CircleScores& bin : bins) {
      if (radius >= bin.from && radius < bin.to) AddCircle(sampled, cover, &bin);
    }
  }
  std::erase_if(bins, [](const CircleScores& bin) { return bin.num_circles == 0; });
  for (CircleScores& bin : bins) bin.covered /= bin.num_circles;
  return bins;
}

}  // namespace limn
