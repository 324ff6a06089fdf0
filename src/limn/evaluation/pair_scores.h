// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/feature_scores.h"

namespace limn {

// By the distance of the two: 2 to 2.5, 2.5 to 4, 4 to 5 footprints; none in world units. True
// curves are chains, `places` those of the true samples on them. O(n log n) in the number of
// samples.
std::vector<PairScores> ScorePairs(const SampledScene& sampled,
                                   const std::vector<ChainPlace>& places);

}  // namespace limn
