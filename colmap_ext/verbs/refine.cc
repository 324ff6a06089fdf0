#include "colmap_ext/verbs/refine.h"

#include <utility>

#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/trust.h"

namespace limn::colmap_ext {

DrawingInScene RefineVerb::Apply(const Job& job, const DrawingInScene& given) {
  const PipelineOptions& options = job.options.pipeline;
  DrawingInScene made = {{}, given.metadata, given.views, CurvesOf(job, given), {}};
  JudgedDrawing judged =
      RefineAndJudge({{given.views, *made.curves, job.scene.view_set().hints}, given.graph},
                     options, job.context(), job.reporter());
  made.cameras = std::move(judged.cameras);
  if (made.cameras) made.views = made.cameras->views;
  made.graph = DescribeLinks(std::move(judged.graph), made.views, job.scene.images().read, options,
                             job.context(), job.reporter());
  CheckGraph(made.graph);
  return made;
}

void RefineVerb::Conclude(const Job& job, const DrawingInScene& given, const DrawingInScene& made) {
  ReportTrust(job.scene.view_set(), made, job.console);
  SayDroppedFaces(given.graph, made.graph, job.console);
  DrawingVerb::Conclude(job, given, made);
}

void RefineVerb::CheckFiles(const Project& project, const RunOptions& options) const {
  CheckRefinedFolder(project, options);
  DrawingVerb::CheckFiles(project, options);
}

void RefineVerb::Write(const Job& job, const Project& project, const DrawingInScene& made) {
  WriteRefinedModel(project, made.cameras, job.console);
  DrawingVerb::Write(job, project, made);
}

}  // namespace limn::colmap_ext
