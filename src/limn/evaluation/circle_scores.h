// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/feature_scores.h"

namespace limn {

// By radius: six bins for footprints, one for world units. O(n log n) in the number of samples.
std::vector<CircleScores> ScoreCircles(const SampledScene& sampled);

}  // namespace limn
