#pragma once

#include "limn/drawing/curve_consistency.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Smooths links as samples are (ALGORITHM.md 7.2), sets their sigmas, and moves nodes to the mean
// of their ends.
void SmoothLinks(double bending_sigma_px, DrawingGraph* graph);

// Fits merged links (see MergeCurves; ALGORITHM.md 11.6). Every vertex moves to the weighted mean
// of the samples merged into it, across the curve; the links are then smoothed (not by the method
// "paper"). Vertices get their support, sigma and agreement (see CountAgreeingViews); their samples
// are renumbered as in the sketch. Linear in the number of samples.
void FitLinks(const SampleSet& samples, const CurveConsistency& network,
              const DrawingOptions& options, DrawingGraph* graph);

}  // namespace limn
