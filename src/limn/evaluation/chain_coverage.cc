// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/chain_coverage.h"

#include <limits>

#include "limn/evaluation/parallel_samples.h"

namespace limn {
namespace {

// The true sample that the sample is given to, or -1.
int NearestParallel(const SampledScene& sampled, int sample,
                    std::vector<SpatialIndex::Neighbor>* scratch) {
  const Eigen::Vector3d& position = sampled.reconstruction.Position(sample);
  FindParallel(sampled.truth, position, sampled.reconstruction.Direction(sample),
               sampled.Radius(1, position), scratch);
  SpatialIndex::Neighbor nearest{-1, std::numeric_limits<double>::infinity()};
  for (const SpatialIndex::Neighbor& neighbor : *scratch) {
    if (neighbor.squared_distance >= nearest.squared_distance) continue;
    if (sampled.scene.InRegion(sampled.truth.Position(neighbor.index))) nearest = neighbor;
  }
  return nearest.index;
}

}  // namespace

ChainCoverage CoverChains(const SampledScene& sampled, const TrueChains& chains,
                          const std::vector<ChainPlace>& places, double arm_taus) {
  const CurveSamples& samples = sampled.reconstruction;
  std::vector<int> given_to(samples.size());
  ForEachSample(sampled.scene.context, samples.size(), [&](int i) {
    thread_local std::vector<SpatialIndex::Neighbor> scratch;
    given_to[i] = NearestParallel(sampled, i, &scratch);
  });
  ChainCoverage coverage;
  for (int i = 0; i < samples.size(); ++i) {
    if (given_to[i] < 0 || places[given_to[i]].chain < 0) continue;
    const auto& [chain, arc] = places[given_to[i]];
    const double unit = sampled.scene.unit_at(samples.Position(i));
    const double length = samples.Weight(i) / unit;
    const double arm = arm_taus * sampled.tau * unit;
    ChainCover& cover = coverage.covers[{chain, samples.CurveOf(i)}];
    cover.length += length;
    if (arc < arm) cover.near_start += length;
    if (arc > chains.chains[chain].length - arm) cover.near_end += length;
  }
  coverage.lengths.assign(chains.chains.size(), 0.0);
  for (int i = 0; i < sampled.truth.size(); ++i) {
    const Eigen::Vector3d& position = sampled.truth.Position(i);
    if (places[i].chain < 0 || !sampled.scene.InRegion(position)) continue;
    coverage.lengths[places[i].chain] += sampled.truth.Weight(i) / sampled.scene.unit_at(position);
  }
  return coverage;
}

void ScorePiecesPerChain(const SampledScene& sampled, const ChainCoverage& coverage,
                         StructureScores* scores) {
  const double min_length = sampled.scene.options.chain_taus * sampled.tau;
  const double min_cover = sampled.scene.options.cover_taus * sampled.tau;
  const std::vector<int>& curves = sampled.scene.reconstruction.curves;
  std::map<std::pair<int, int>, double> by_curve;
  std::vector<int> num_links(coverage.lengths.size());
  for (const auto& [key, cover] : coverage.covers) {
    const auto& [chain, link] = key;
    num_links[chain] += cover.length >= min_cover;
    by_curve[{chain, curves.empty() ? link : curves[link]}] += cover.length;
  }
  std::vector<int> num_curves(coverage.lengths.size());
  for (const auto& [key, length] : by_curve) num_curves[key.first] += length >= min_cover;
  double sum_of_links = 0;
  double sum_of_curves = 0;
  double total = 0;
  for (size_t chain = 0; chain < num_links.size(); ++chain) {
    if (!(coverage.lengths[chain] >= min_length)) continue;
    ++scores->num_chains;
    if (num_links[chain] == 0) continue;
    ++scores->num_drawn_chains;
    sum_of_links += num_links[chain] * coverage.lengths[chain];
    sum_of_curves += num_curves[chain] * coverage.lengths[chain];
    total += coverage.lengths[chain];
  }
  if (!(total > 0)) return;
  scores->links_per_chain = sum_of_links / total;
  scores->curves_per_chain = sum_of_curves / total;
}

}  // namespace limn
