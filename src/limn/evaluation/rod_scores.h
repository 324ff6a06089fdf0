// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/evaluation/evaluation_options.h"
#include "limn/evaluation/feature_scores.h"
#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// A drawing in two, by the kinds of its links.
struct RodsApart {
  DrawingGraph rods, others;
};

RodsApart TakeRodsApart(const DrawingGraph& drawing);

// What is compared: drawn rods with their radii, all else that is drawn, and true center lines,
// with radii where these are known.
struct RodComparison {
  const CurveSet& rods;
  const CurveSet& others;
  const CurveSet& truth;
};

// Per tau of the options; inside their region. Distances are in pixel footprints of the views at
// the place they are measured from, or in world units if there are none. Precondition: the options
// are valid and all points finite. O(n log n) in the total length / tau, times the number of
// copies. Throws InputError if that is too long or the truth has no curves.
std::vector<RodScores> ScoreRods(const RodComparison& compared, const std::vector<View>& views,
                                 const EvaluationOptions& options, const RunContext& context = {});

}  // namespace limn
