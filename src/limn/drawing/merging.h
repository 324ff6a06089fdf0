#pragma once

#include <memory>
#include <vector>

#include "limn/drawing/curve_consistency.h"
#include "limn/drawing/link_builder.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// The links of a drawing before their geometry is fitted, and where every sample went.
struct MergedCurves {
  std::vector<LinkBuilder::Link> links;
  // Per vertex: the sample that it was made from.
  std::vector<int> vertex_sample;
  // Per sample: the vertex it is merged into, -1 if none.
  std::vector<int> home;
  int num_nodes = 0;
  MergingCounts counts;
};

// Merge the averaged curves into links (ECCV 2016, section 5). Curves are taken longest first. A
// sample that runs along a link already there, by the consistency network or because both reproject
// within the merge distance, is absorbed; the runs of samples between are new: they become links,
// and at either end where the curve goes on along an existing link the fitting primitive joins them
// (LinkBuilder). Every sample ends up in a link or in a stub.
MergedCurves MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const DrawingOptions& options,
                         const RunContext& context);

}  // namespace limn
