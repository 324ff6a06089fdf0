// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/pair_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "limn/evaluation/parallel_samples.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr std::array kDistances = {2.0, 2.5, 4.0, 5.0};
// The other curve is beside the sample, not ahead of it.
const double kMaxAheadCosine = std::sin(20 * kDeg);

using Neighbors = std::vector<SpatialIndex::Neighbor>;

struct Partner {
  int chain = -1;
  double distance = kDistances.back();  // footprints
};

// What a sample of the truth is found to be.
struct PairSample {
  int bin = -1;
  bool found = false;
};

// Per chain its nearest one.
std::map<int, SpatialIndex::Neighbor> NearestOfChains(const Neighbors& samples,
                                                      const std::vector<ChainPlace>& places) {
  std::map<int, SpatialIndex::Neighbor> nearest;
  for (const SpatialIndex::Neighbor& sample : samples) {
    SpatialIndex::Neighbor& best =
        nearest.try_emplace(places[sample.index].chain, sample).first->second;
    if (sample.squared_distance < best.squared_distance) best = sample;
  }
  return nearest;
}

// The nearest other chain that runs beside the sample at a distance that counts.
Partner FindPartner(const SampledScene& sampled, const std::vector<ChainPlace>& places, int sample,
                    Neighbors* scratch) {
  const Eigen::Vector3d& position = sampled.truth.Position(sample);
  const Eigen::Vector3d direction = sampled.truth.Direction(sample);
  const double unit = sampled.scene.unit_at(position);
  FindParallel(sampled.truth, position, direction, kDistances.back() * unit, scratch);
  Partner partner;
  for (const auto& [chain, nearest] : NearestOfChains(*scratch, places)) {
    const double distance = std::sqrt(nearest.squared_distance) / unit;
    if (chain < 0 || chain == places[sample].chain) continue;
    if (distance < kDistances.front() || distance >= partner.distance) continue;
    const Eigen::Vector3d offset =
        ClosestPoint(sampled.truth.Cell(nearest.index), position).position - position;
    if (std::abs(offset.dot(direction)) > kMaxAheadCosine * offset.norm()) continue;
    partner = {chain, distance};
  }
  return partner;
}

// Whether the place, which is within `radius` of chain `own`, is nearer to it than to `other`.
bool IsNearerTo(int own, int other, const Eigen::Vector3d& place, double radius,
                const CurveSamples& truth, const std::vector<ChainPlace>& places,
                Neighbors* scratch) {
  double to_own = std::numeric_limits<double>::infinity();
  double to_other = std::numeric_limits<double>::infinity();
  truth.FindNear(place, radius, scratch);
  for (const SpatialIndex::Neighbor& near : *scratch) {
    const int chain = places[near.index].chain;
    if (chain != own && chain != other) continue;
    const double squared = ClosestPoint(truth.Cell(near.index), place).squared_distance;
    double& nearest = chain == own ? to_own : to_other;
    nearest = std::min(nearest, squared);
  }
  return to_own < to_other;
}

bool IsFound(const SampledScene& sampled, const std::vector<ChainPlace>& places, int sample,
             int partner, Neighbors* scratch) {
  const Eigen::Vector3d& position = sampled.truth.Position(sample);
  const double radius = sampled.Radius(1, position);
  FindParallel(sampled.reconstruction, position, sampled.truth.Direction(sample), radius, scratch);
  if (scratch->empty()) return false;
  const int drawn =
      std::ranges::min_element(*scratch, {}, &SpatialIndex::Neighbor::squared_distance)->index;
  const Eigen::Vector3d place = ClosestPoint(sampled.reconstruction.Cell(drawn), position).position;
  return IsNearerTo(places[sample].chain, partner, place, radius, sampled.truth, places, scratch);
}

PairSample Judge(const SampledScene& sampled, const std::vector<ChainPlace>& places, int sample,
                 Neighbors* scratch) {
  PairSample judged;
  if (places[sample].chain < 0 || !sampled.scene.InRegion(sampled.truth.Position(sample))) {
    return judged;
  }
  const Partner partner = FindPartner(sampled, places, sample, scratch);
  if (partner.chain < 0) return judged;
  judged.bin = 0;
  while (partner.distance >= kDistances[judged.bin + 1]) ++judged.bin;
  judged.found = IsFound(sampled, places, sample, partner.chain, scratch);
  return judged;
}

}  // namespace

std::vector<PairScores> ScorePairs(const SampledScene& sampled,
                                   const std::vector<ChainPlace>& places) {
  if (!sampled.scene.in_footprints) return {};
  std::vector<PairSample> judged(sampled.truth.size());
  ForEachSample(sampled.scene.context, sampled.truth.size(), [&](int i) {
    thread_local Neighbors scratch;
    judged[i] = Judge(sampled, places, i, &scratch);
  });
  std::vector<PairScores> bins(kDistances.size() - 1);
  std::vector<double> found(bins.size());
  for (size_t i = 0; i < judged.size(); ++i) {
    if (judged[i].bin < 0) continue;
    const double length = sampled.truth.Weight(static_cast<int>(i));
    bins[judged[i].bin].true_length += length;
    if (judged[i].found) found[judged[i].bin] += length;
  }
  for (size_t bin = 0; bin < bins.size(); ++bin) {
    bins[bin].from = kDistances[bin];
    bins[bin].to = kDistances[bin + 1];
    if (bins[bin].true_length > 0) bins[bin].recall = found[bin] / bins[bin].true_length;
  }
  return bins;
}

}  // namespace limn
