// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/drawing/samples.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/parallel.h"

namespace limn {

// Set by tests only.
struct TracingOptions {
  // Curves start where samples of this many primary views agree, and continue where at least the
  // second number do.
  int min_seed_views = 2;
  int min_traced_views = 1;
  // Longest gap that a curve bridges, px.
  double max_gap_px = 6;
};

struct TracingCounts {
  int64_t curves = 0;
  int64_t closed = 0;     // curves that reached their own start
  int64_t meetings = 0;   // ends that reached another curve, or their own interior
  int64_t unclaimed = 0;  // samples of the sketch that no curve stands for
};

// Traces the ridges of the consensus of all samples (ours; algorithm/drawing.md#consensus). Curves
// start at the places where samples of most primary views agree and follow the ridge in both
// directions. Where they reach another curve, they end in a node on it; where they reach their own
// start, they close. A vertex has the samples that it stands for, by their names in the sketch, and
// their edgels. Points are not smoothed, sigmas are 0. The graph passes Validate(). Time: O(n log
// n) in the number of samples.
DrawingGraph TraceCurves(const SampleSet& samples, const TracingOptions& options,
                         const RunContext& context, TracingCounts* counts);

}  // namespace limn
