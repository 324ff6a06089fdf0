// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/paper/curve_consistency.h"

namespace limn {

// Fits merged links (see MergeCurves; algorithm/paper.md#fit-of-merged-links). Every vertex moves
// to the weighted mean of the samples merged into it, across the curve. Vertices get their support,
// sigma and agreement (see CountAgreeingViews); their samples are renumbered as in the sketch.
// Linear in the number of samples.
void FitLinks(const SampleSet& samples, const CurveConsistency& network, DrawingGraph* graph);

}  // namespace limn
