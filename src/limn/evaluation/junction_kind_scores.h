// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/evaluation/evaluation_scene.h"
#include "limn/evaluation/feature_scores.h"

namespace limn {

// Of the truth's own junctions of this kind.
JunctionKindScores ScoreJunctionsOfKind(const EvaluationScene& scene, JunctionKind kind,
                                        double tau);

}  // namespace limn
