// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/refine.h"

#include <utility>

#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/trust.h"

namespace limn::colmap_ext {

DrawingInScene RefineVerb::Apply(const Job& job, const DrawingInScene& given) {
  const PipelineOptions& options = job.options.pipeline;
  DrawingInScene made = {{}, given.metadata, given.views, CurvesOf(job, given)};
  DrawingGraph graph = RefineAndJudge({{given.views, *made.curves}, given.graph}, options,
                                      job.context(), job.reporter());
  made.graph = DescribeLinks(std::move(graph), made.views, job.scene.images().read, options,
                             job.context(), job.reporter());
  CheckGraph(made.graph);
  return made;
}

void RefineVerb::Conclude(const Job& job, const DrawingInScene& given, const DrawingInScene& made) {
  ReportTrust(job.scene.view_set(), made, job.console);
  SayDroppedFaces(given.graph, made.graph, job.console);
  DrawingVerb::Conclude(job, given, made);
}

}  // namespace limn::colmap_ext
