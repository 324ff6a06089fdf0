#pragma once

#include <vector>

#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/merging_primitives.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

struct MergedCurves {
  // Links before their geometry is fitted. Every vertex knows the samples merged into it, in the
  // numbers of the sample set, the one it was made from first.
  DrawingGraph graph;
  MergingCounts counts;
};

// Merge the averaged curves into links (ECCV 2016, section 3). Curves are taken longest first. A
// sample that runs along a link already there, by the consistency network or because both reproject
// within the merge distance, is absorbed; the runs of samples between are new: they become links,
// and at either end where the curve goes on along an existing link the fitting primitive joins them
// (MergingPrimitives). Every sample ends up in a link.
MergedCurves MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const DrawingOptions& options,
                         const RunContext& context);

}  // namespace limn
