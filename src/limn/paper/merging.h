// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/view.h"
#include "limn/paper/curve_consistency.h"
#include "limn/paper/merging_primitives.h"
#include "limn/util/parallel.h"

namespace limn {

// Merges the averaged curves into links (ECCV 2016, section 3; algorithm/paper.md#order-and-homes).
// Curves are taken longest first. A sample that runs along an existing link, by the consistency
// network or because both reproject within the merge distance, is absorbed. The runs between
// absorbed samples become links; where the curve continues along an existing link, a primitive
// attaches the run to it (MergingPrimitives). Every sample ends up in a link. The geometry of the
// links is not fitted yet; every vertex lists the samples merged into it, as curves and samples of
// the SampleSet, beginning with the one it was made from.
DrawingGraph MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const PaperOptions& options,
                         const RunContext& context, MergingCounts* counts);

}  // namespace limn
