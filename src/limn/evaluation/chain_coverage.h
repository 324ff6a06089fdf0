// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/structure_scores.h"

namespace limn {

// How much of a true chain a link covers: lengths of the link, world units.
struct ChainCover {
  double length = 0;
  // Within arm_taus of the chain's start and of its end.
  double near_start = 0;
  double near_end = 0;
};

struct ChainCoverage {
  // Keys: chain, link.
  std::map<std::pair<int, int>, ChainCover> covers;
  // Per chain, the length inside the region, in units of the scene.
  std::vector<double> lengths;
};

// Every sample of a link is given to the nearest of the true samples that are within tau, inside
// the region and parallel to it within 20 degrees. `arm_taus` is how long arms are, in taus. O(n
// log n) in the number of samples.
ChainCoverage CoverChains(const SampledScene& sampled, const TrueChains& chains,
                          const std::vector<ChainPlace>& places, double arm_taus);

// Fills in the scores of links and of curves per chain.
void ScorePiecesPerChain(const SampledScene& sampled, const ChainCoverage& coverage,
                         StructureScores* scores);

}  // namespace limn
