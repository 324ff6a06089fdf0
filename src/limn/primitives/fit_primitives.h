#pragma once

#include <optional>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/primitives/primitive_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct PrimitiveResult {
  DrawingGraph graph;  // its links with their primitives, its nodes where these meet
  StageSummary summary;
};

// Explains every link by the simplest curve within max_residual_px: a line, a circular arc (a
// circle if the link is closed), else a cubic B-spline with as few knots as do. Where more than one
// would do, Bayes' information criterion chooses: squared deviations over noise_px, one independent
// place per correlation_px, against the number of parameters. Nodes where links meet move to where
// their shapes, fitted without them, meet, and the links' points near them along; then all shapes
// are fitted with their ends held there. Free ends move along with the fit. Splines leave a node in
// the direction of the link that continues them. A link that no view sees gets none. Throws
// OptionError and Cancelled.
PrimitiveResult FitPrimitives(const DrawingGraph& graph, const std::vector<View>& views,
                              const PrimitiveOptions& options, const RunContext& context);

// What primitives make of a drawing.
struct PrimitiveStatistics {
  struct Kind {
    const char* name = "";
    int count = 0;
    double length = 0;  // world units
  };
  std::vector<Kind> kinds;  // lines, arcs, circles, splines, links without
  // Deviations of the links' points, weighted by length: root of the mean square and the largest.
  double rms_px = 0;
  double max_px = 0;
  size_t numbers_before = 0;  // coordinates of the links' points
  size_t numbers_after = 0;
};
PrimitiveStatistics Describe(const DrawingGraph& graph);

}  // namespace limn
