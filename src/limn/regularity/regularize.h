// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/primitives/primitive_options.h"
#include "limn/regularity/regularity_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// How far ends of links moved, as their images see it.
struct RegularityMoves {
  int num_ends = 0;
  double median_px = 0;
  double max_px = 0;
};

struct RegularityResult {
  DrawingGraph graph;  // with its regularities
  RegularityMoves moves;
  StageSummary summary;
};

// Finds what the lines and arcs of a drawing have in common (ours; algorithm/regularity.md):
// directions that are parallel or perpendicular, planes, radii and axes; then fits all of them
// again under these regularities. A link whose residual in the images would grow by more than
// max_growth_px leaves the regularities that strain it. `primitives` are the options with which the
// primitives were fitted, for their noise. Points of links move with their shapes, curves of other
// shapes with the nodes that they end at; faces bounded by links that moved are dropped. Links
// without a primitive, tentative ones and outlines follow no regularity. The result does not depend
// on the number of threads. Throws OptionError and Cancelled.
RegularityResult Regularize(const DrawingGraph& graph, const std::vector<View>& views,
                            const RegularityOptions& options, const PrimitiveOptions& primitives,
                            const RunContext& context);

// The regularities of a drawing, in words: "directions of 212 links: 3, 2 of them at right angles,
// ...".
std::string DescribeRegularities(const DrawingGraph& graph);

}  // namespace limn
