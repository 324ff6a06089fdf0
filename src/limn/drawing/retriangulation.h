#pragma once

#include <memory>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/support/view_edgels.h"

namespace limn {

struct RetriangulationStats {
  int64_t samples_in = 0;
  int64_t too_few_views = 0;    // lost support when the sample moved to where its edgels agree
  int64_t piece_too_short = 0;  // what was left of the curve between such samples
};

// Move every sample of the sketch to where the tangent lines of all its supporting edgels agree
// (algorithm.md 0.1 item 2): robust least squares of their distances in all views, free across the
// curve, fixed along it, alternated with smoothing along the curve in which every sample weighs by
// its covariance, and with a new choice of supporting edgels. Curves are cut where support is lost.
// Time: samples times views.
SampleSet Retriangulate(const CurveSketch& sketch, const std::vector<View>& views,
                        const std::vector<ImageCurves>& curves,
                        const std::vector<std::unique_ptr<ViewEdgels>>& edgels,
                        const DrawingOptions& options, const RunContext& context,
                        RetriangulationStats* stats);

}  // namespace limn
