// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/regularize.h"

#include <cstdio>
#include <utility>

#include "colmap_ext/verbs/drawing_results.h"
#include "limn/regularity/regularize.h"

namespace limn::colmap_ext {
namespace {

// What is regular, and how far ends of links moved for it.
void SayRegularities(const DrawingGraph& graph, const RegularityMoves& moves, Console* console) {
  char text[120];
  std::snprintf(text, sizeof(text), "; %d ends moved, %.2f px (median; at most %.2f)",
                moves.num_ends, moves.median_px, moves.max_px);
  console->Say("regularities: " + DescribeRegularities(graph) + text);
}

}  // namespace

void RegularizeVerb::Prepare(RunOptions* options, Console*) { options->pipeline.regularize = true; }

DrawingInScene RegularizeVerb::Apply(const Job& job, const DrawingInScene& given) {
  const PipelineOptions& options = job.options.pipeline;
  RegularityResult result =
      Regularize(given.graph, given.views, options.regularity, options.primitives, job.context());
  job.console->Report(result.summary);
  CheckGraph(result.graph);
  SayRegularities(result.graph, result.moves, job.console);
  SayDroppedFaces(given.graph, result.graph, job.console);
  DrawingInScene made = {std::move(result.graph), given.metadata, given.views, given.curves};
  return made;
}

}  // namespace limn::colmap_ext
