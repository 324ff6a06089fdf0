// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/evaluation/chain_coverage.h"
#include "limn/evaluation/feature_scores.h"

namespace limn {

// Each fills in the scores it is named for, connectivity also those of corners.

// Free ends; without true chains only their number.
void ScoreFreeEnds(const SampledScene& sampled, const TrueChains& chains, double true_length,
                   StructureScores* scores);

// False junctions, degrees and arms. Where the truth has no nodes of its own, degrees and arms, and
// what is joined, are judged only at true nodes all of whose arms are longer than junction_taus:
// the edges of a mesh are too short to be distinguished.
void ScoreJunctions(const SampledScene& sampled, const TrueChains& chains, double true_length,
                    StructureScores* scores);

// `coverage` with arms of kArmTaus. An arm is drawn by the links that cover half of it, or of its
// chain if that is shorter. Two arms are joined if a link draws both, or if two links that draw
// them are connected at nodes within junction_taus of the true node.
void ScoreConnectivity(const SampledScene& sampled, const TrueChains& chains,
                       const ChainCoverage& coverage, StructureScores* scores,
                       CornerScores* corners);

// How far from a node its arms are looked at, in taus.
inline constexpr double kArmTaus = 4;

}  // namespace limn
