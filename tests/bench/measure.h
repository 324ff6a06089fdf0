// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bench/data_sets.h"
#include "bench/json.h"
#include "bench/measures/supported_curve.h"
#include "bench/scene.h"
#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/parallel.h"

namespace limn::bench {

// The truth of a data set, read. Empty sets of curves: there is none.
struct Truth {
  CurveSet curves;
  CurveSet dont_care;
  CurveSet emap_curves;
  CurveSet rods;  // center lines
  std::vector<NamedBox> boxes;

  bool IsKnown() const { return !curves.polylines.empty() || !curves.points.empty(); }
};

// Throws IoError.
Truth ReadTruth(const DataSet& set);

// How a reconstruction compares with the truth: for every box the report of EvaluateCurves by the
// name of the box; nothing without truth.
Json MeasureAgainstTruth(const DataSet& set, const Truth& truth, const std::vector<View>& views,
                         const CurveSet& reconstruction, bool find_duplicates,
                         const RunContext& context);

// How well the sigmas of a drawing tell its errors, per box (see normalized_errors.h); nothing
// without true curves.
Json MeasureSigmas(const Truth& truth, const std::vector<View>& views, const DrawingGraph& graph);

// Per box, for every tau how the rods of a drawing compare with the true ones (rod_scores.h);
// nothing without these.
Json MeasureRods(const DataSet& set, const Truth& truth, const std::vector<View>& views,
                 const DrawingGraph& graph, const RunContext& context);

// The report of CountCurves with saw-teeth: what needs no truth.
Json MeasureShape(const CurveSet& reconstruction, const std::vector<View>& views);

// EMAP's protocol with and without averaging in voxels; nothing without its truth.
Json MeasureByEmap(const Truth& truth, const CurveSet& reconstruction);

// Curves made from `training`, in views that are not among them.
Json MeasureHeldOutViews(const Scene& training, const Scene& held_out,
                         const std::vector<SupportedCurve>& curves, const RunContext& context);

// For every box by its name, the share of the truth that the image curves show at all, per tau.
Json MeasureCeiling(const DataSet& set, const Truth& truth, const Scene& scene,
                    const RunContext& context);

}  // namespace limn::bench
