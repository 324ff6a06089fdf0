#pragma once

#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Fit merged links (see MergeCurves): every vertex moves to the weighted mean of the samples merged
// into it, across the curve; then the link is smoothed by the same rule as the samples, and nodes
// go to the mean of their ends. Vertices get their support, sigma, and agreement of primary views
// (`agreeing_views`, per sample, see CountAgreeingViews), and name their samples as the sketch
// does. Linear in the number of samples.
void FitLinks(const SampleSet& samples, const std::vector<int>& agreeing_views,
              const DrawingOptions& options, DrawingGraph* graph);

}  // namespace limn
