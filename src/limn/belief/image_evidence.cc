// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/image_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/support/segment_support.h"

namespace limn {
namespace {

constexpr double kSampleSpacingPx = 1.5;
// A view shows a link around a sample if edgels run along this share of the samples within half a
// window.
constexpr int kHalfWindow = 4;  // samples
constexpr double kMinShownShare = 0.5;
// Edgels of a true edge lie within a fraction of a pixel if the cameras are exact, those of an
// accident anywhere in the gate: the widest gate times each of these is tried.
constexpr std::array<double, 3> kGateScales = {1, 0.5, 0.25};
constexpr size_t kMaxProbes = 60;

std::vector<EvidenceSample> MakeSamples(const DrawingLink& link, double footprint) {
  std::vector<EvidenceSample> samples;
  const Polyline3d points = ResampleUniform(link.points_in_world, kSampleSpacingPx * footprint);
  for (size_t k = 0; k + 1 < points.size(); ++k) {
    const Eigen::Vector3d step = points[k + 1] - points[k];
    if (step.norm() > 0) samples.push_back({0.5 * (points[k] + points[k + 1]), step.normalized()});
  }
  return samples;
}

// Per gate, how many were counted.
using PerGate = std::array<double, kGateScales.size()>;

void Count(double residual_px, double gate_px, PerGate* counts) {
  for (size_t g = 0; g < kGateScales.size(); ++g) {
    (*counts)[g] += std::abs(residual_px) <= kGateScales[g] * gate_px;
  }
}

struct Counts {
  double contained = 0;  // samples in views
  PerGate hits = {};
  double copies = 0;
  PerGate copies_hit = {};
};

// What edgels of a view run along the copies of a sample.
void CountCopies(const TopologyInput& input, ViewId view, const CurveSight& sight, Counts* counts) {
  for (const double shift : kChanceShiftsPx) {
    const Eigen::Vector2d place = sight.position_px + shift * sight.Across();
    if (!input.views[view].region.Contains(place)) continue;
    ++counts->copies;
    const auto match = input.edgels[view]->edgels.Best(place, sight.direction, input.gate);
    if (match) Count(match->normal_residual_px, input.gate.normal_px, &counts->copies_hit);
  }
}

// The edgels that run along stretches of the link which the view shows.
std::vector<SampleHit> ShownHits(const std::vector<uint8_t>& contained,
                                 const std::vector<std::optional<EdgelMatch>>& matches) {
  std::vector<SampleHit> hits;
  const int size = static_cast<int>(matches.size());
  for (int k = 0; k < size; ++k) {
    if (!matches[k]) continue;
    int num_contained = 0;
    int num_matched = 0;
    for (int j = std::max(0, k - kHalfWindow); j <= std::min(size - 1, k + kHalfWindow); ++j) {
      num_contained += contained[j];
      num_matched += matches[j].has_value();
    }
    if (num_matched < kMinShownShare * num_contained) continue;
    hits.push_back({k, matches[k]->edgel, static_cast<float>(matches[k]->normal_residual_px)});
  }
  return hits;
}

LinkSight SightOf(const TopologyInput& input, ViewId view,
                  const std::vector<EvidenceSample>& samples, Counts* counts) {
  const size_t stride = std::max<size_t>(1, samples.size() / kMaxProbes);
  std::vector<uint8_t> contained(samples.size(), 0);
  std::vector<std::optional<EdgelMatch>> matches(samples.size());
  for (size_t k = 0; k < samples.size(); ++k) {
    const auto sight = See(input.views[view], samples[k].position, samples[k].tangent);
    if (!sight) continue;
    contained[k] = 1;
    ++counts->contained;
    matches[k] = input.edgels[view]->edgels.Best(sight->position_px, sight->direction, input.gate);
    if (k % stride == 0) CountCopies(input, view, *sight, counts);
  }
  LinkSight shown = {view, ShownHits(contained, matches)};
  for (const SampleHit& hit : shown.hits) {
    Count(hit.residual_px, input.gate.normal_px, &counts->hits);
  }
  return shown;
}

double EvidenceOf(const Counts& counts, double num_samples) {
  double evidence = 0;
  for (size_t g = 0; g < kGateScales.size(); ++g) {
    const double share = counts.copies > 0 ? counts.copies_hit[g] / counts.copies : 0;
    const double background = std::max(share, kGateScales[g] * kMinChance);
    evidence = std::max(evidence, -LogChance(counts.hits[g] / num_samples,
                                             counts.contained / num_samples, background));
  }
  return evidence;
}

// Of the hits that have the property; `of_none` without hits.
double ShareOfHits(const std::vector<LinkSight>& sights, bool SampleHit::*property,
                   double of_none) {
  double num_hits = 0, num_with = 0;
  for (const LinkSight& sight : sights) {
    num_hits += static_cast<double>(sight.hits.size());
    num_with += static_cast<double>(std::ranges::count(sight.hits, true, property));
  }
  return num_hits > 0 ? num_with / num_hits : of_none;
}

}  // namespace

double ImageEvidence::OwnShare() const { return ShareOfHits(sights, &SampleHit::own, 1); }

double ImageEvidence::ElsewhereShare() const {
  return ShareOfHits(sights, &SampleHit::elsewhere, 0);
}

ImageEvidence FindEvidence(const TopologyInput& input, const ViewFinder& finder,
                           const DrawingLink& link) {
  ImageEvidence found;
  found.footprint = LinkFootprint(link, input.views);
  if (!(found.footprint > 0)) return found;
  found.samples = MakeSamples(link, found.footprint);
  if (found.samples.empty()) return found;
  Counts counts;
  for (const ViewId view : finder.NearAnyOf(link.points_in_world)) {
    found.sights.push_back(SightOf(input, view, found.samples, &counts));
  }
  const auto num_samples = static_cast<double>(found.samples.size());
  found.containing_views = counts.contained / num_samples;
  found.showing_views = counts.hits[0] / num_samples;
  found.evidence = EvidenceOf(counts, num_samples);
  return found;
}

}  // namespace limn
