#pragma once

#include "limn/drawing/curve_consistency.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Fits merged links (see MergeCurves; ALGORITHM.md 11.3). Every vertex moves to the weighted mean
// of the samples merged into it, across the curve; the link is then smoothed like the samples, and
// nodes move to the mean of their ends. Vertices get their support, sigma and agreement
// (see CountAgreeingViews); their samples are renumbered as in the
// sketch. Linear in the number of samples.
void FitLinks(const SampleSet& samples, const CurveConsistency& network,
              const DrawingOptions& options, DrawingGraph* graph);

}  // namespace limn
