// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/sample_homes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/geometry/angle_between.h"
#include "limn/support/edgel_residual.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Vertices farther than this from a sample are not compared with it, px.
constexpr double kSearchPx = 6;
// A curve that returns to itself after less than this is not a loop, px.
constexpr double kMinLoopPx = 20;
// Cosine of the largest angle between the direction of an end and the curve it runs into.
constexpr double kMinAheadCosine = 0.5;
// Vertices up to this many times as far as the nearest are touched, too.
constexpr double kTouchRatio = 2;

}  // namespace

SampleHomes::SampleHomes(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const PaperOptions& options,
                         const MergingPrimitives& primitives)
    : samples_(samples),
      network_(network),
      views_(views),
      options_(options),
      primitives_(primitives),
      index_(samples.position) {}

// Median over the supporting views of the distance, across the curve, between the reprojections.
double SampleHomes::ReprojectedDistancePx(int sample, int vertex) const {
  std::vector<double> distances;
  const Eigen::Vector3d& position = samples_.position[sample];
  for (const EdgelRef& ref : samples_.support.Of(sample)) {
    const View& view = views_[ref.view];
    const auto direction = ProjectedDirection(view, position, samples_.tangent[sample]);
    if (!direction) continue;
    const EdgelLine line(view.camera.Project(view.cam_from_world * position),
                         {direction->y(), -direction->x()});
    const auto residual = ResidualToEdgel(view, line, samples_.position[vertex]);
    if (residual) distances.push_back(std::abs(residual->residual_px));
  }
  if (distances.empty()) return std::numeric_limits<double>::infinity();
  return Median(std::move(distances));
}

SampleHomes::Candidate SampleHomes::CandidateFor(int sample, int vertex) const {
  return {(samples_.position[vertex] - samples_.position[sample]).squaredNorm(), vertex};
}

bool SampleHomes::IsAlong(int sample, int vertex) const {
  return LineAngleBetween(samples_.tangent[vertex], samples_.tangent[sample]) <=
         options_.max_link_angle_deg * kDeg;
}

bool SampleHomes::Covers(int sample, const Candidate& best) const {
  const double footprint = samples_.footprint[sample];
  if (best.squared_distance > std::pow(kSearchPx * footprint, 2)) return false;
  // Along the curve a vertex stands for its neighborhood only.
  const double along = std::abs(
      samples_.tangent[sample].dot(samples_.position[best.vertex] - samples_.position[sample]));
  if (along > options_.junction_distance_px * footprint) return false;
  return ReprojectedDistancePx(sample, best.vertex) <= options_.merge_distance_px;
}

// Merges the curves of a cluster only.
bool SampleHomes::MayMerge(int sample, int vertex) const {
  return network_.cluster_of[samples_.curve_of[sample]] ==
         network_.cluster_of[samples_.curve_of[vertex]];
}

int SampleHomes::Find(int sample) const {
  const auto [curve, k] = samples_.NameOf(sample);
  Candidate best;
  const auto consider = [&](int vertex) {
    const Candidate candidate = CandidateFor(sample, vertex);
    if (candidate < best && IsAlong(sample, vertex)) best = candidate;
  };
  for (const CurveOverlap& overlap : network_.overlaps[curve]) {
    const int home = overlap.partner[k] < 0 ? -1 : primitives_.HomeOf(overlap.partner[k]);
    if (home >= 0) consider(home);
  }
  if (Covers(sample, best)) return best.vertex;
  best = {};
  std::vector<SpatialIndex::Neighbor> near;
  index_.FindWithin(samples_.position[sample], kSearchPx * samples_.footprint[sample], &near);
  for (const SpatialIndex::Neighbor& other : near) {
    if (primitives_.IsVertex(other.index) && MayMerge(sample, other.index)) consider(other.index);
  }
  return Covers(sample, best) ? best.vertex : -1;
}

void SampleHomes::FindOwn(int curve, std::vector<int>* homes) const {
  const int first = samples_.curve_begin[curve];
  const std::vector<double> arc = ArcPx(samples_, curve);
  std::vector<SpatialIndex::Neighbor> near;
  for (int k = 0; k < samples_.Size(curve); ++k) {
    if ((*homes)[k] >= 0 || arc[k] < kMinLoopPx) continue;
    const int sample = first + k;
    Candidate best;
    index_.FindWithin(samples_.position[sample], kSearchPx * samples_.footprint[sample], &near);
    for (const SpatialIndex::Neighbor& other : near) {
      const int earlier = other.index - first;
      if (earlier < 0 || earlier > k || arc[k] - arc[earlier] < kMinLoopPx) continue;
      if ((*homes)[earlier] >= 0 || !IsAlong(sample, other.index)) continue;
      if (samples_.tangent[sample].dot(samples_.tangent[other.index]) < 0) continue;
      best = std::min(best, CandidateFor(sample, other.index));
    }
    if (Covers(sample, best)) (*homes)[k] = best.vertex;
  }
}

int SampleHomes::FindAhead(int sample) const {
  const auto [curve, k] = samples_.NameOf(sample);
  const std::vector<double> arc = ArcPx(samples_, curve);
  const Eigen::Vector3d outward = (k == 0 ? -1 : 1) * samples_.tangent[sample];
  Candidate best;
  std::vector<SpatialIndex::Neighbor> near;
  const double reach = options_.junction_distance_px * samples_.footprint[sample];
  index_.FindWithin(samples_.position[sample], reach, &near);
  for (const SpatialIndex::Neighbor& other : near) {
    if (samples_.curve_of[other.index] != curve || IsAlong(sample, other.index)) continue;
    if (std::abs(arc[k] - arc[samples_.NameOf(other.index).sample]) < kMinLoopPx) continue;
    const Eigen::Vector3d offset = samples_.position[other.index] - samples_.position[sample];
    if (offset.dot(outward) < kMinAheadCosine * offset.norm()) continue;
    best = std::min(best, CandidateFor(sample, other.index));
  }
  return best.vertex;
}

std::vector<int> SampleHomes::FindTouched(int sample, int home) const {
  std::vector<int> touched = {home};
  const int vertex = primitives_.HomeOf(home);
  // A home among the curve's own samples is not in a link yet.
  const LinkId own = vertex < 0 ? -1 : primitives_.LinkOf(home);
  std::map<LinkId, Candidate> nearest;
  std::vector<SpatialIndex::Neighbor> near;
  const double distance = (samples_.position[home] - samples_.position[sample]).norm();
  index_.FindWithin(samples_.position[sample], kTouchRatio * distance, &near);
  for (const SpatialIndex::Neighbor& other : near) {
    if (!primitives_.IsVertex(other.index) || !MayMerge(sample, other.index)) continue;
    const LinkId link = primitives_.LinkOf(other.index);
    if (link == own || !IsAlong(sample, other.index)) continue;
    const Candidate candidate = CandidateFor(sample, other.index);
    if (!Covers(sample, candidate)) continue;
    Candidate& best = nearest[link];
    best = std::min(best, candidate);
  }
  for (const auto& [link, candidate] : nearest) touched.push_back(candidate.vertex);
  return touched;
}

}  // namespace limn
