// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/primitives/primitive_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct PrimitiveResult {
  DrawingGraph graph;  // links with their primitives, nodes where these meet
  StageSummary summary;
};

// Explains every link by the simplest curve within max_residual_px (ours; algorithm/primitives.md):
// a line, a circular arc (a circle if the link returns to its start), or a cubic B-spline with as
// few knots as needed. If several qualify, the Bayesian information criterion chooses, weighing
// squared deviations over noise_px, one independent place per correlation_px, against the number of
// parameters. Nodes move to where the shapes of their links, fitted freely, meet, and nearby points
// of the links follow; then all shapes are fitted with their ends held there. Free ends move with
// the fit. Splines leave a node in the direction of the link that continues them. A link that no
// view sees, or whose best shape leaves it (IsAlongLink), gets no primitive. Drops regularities and
// faces. Throws OptionError and Cancelled.
PrimitiveResult FitPrimitives(const DrawingGraph& graph, const std::vector<View>& views,
                              const PrimitiveOptions& options, const RunContext& context);

// The same for some links of a drawing (`refit`, one per link). All else stays as it is: the other
// links with their primitives, nodes that they end at, and regularities. Throws OptionError and
// Cancelled.
DrawingGraph RefitPrimitives(const DrawingGraph& graph, const std::vector<uint8_t>& refit,
                             const std::vector<View>& views, const PrimitiveOptions& options,
                             const RunContext& context);

// Statistics of the primitives of a drawing.
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
