// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/job.h"

namespace limn::colmap_ext {

StageObserver Job::reporter() const {
  return [to = console](const StageSummary& summary) { to->Report(summary); };
}

CurvesScene Job::WithCurves(const std::vector<ImageCurves>& curves) const {
  return {views(), curves, scene.view_set().hints, SceneBox(scene, options)};
}

Job JobOf(const Project& project, const RunOptions& options, Console* console) {
  return {project, options, console, project.cache()};
}

CurvesResult ExtractImageCurves(const Job& job, const FragmentsObserver& on_fragments) {
  CurvesResult result =
      ExtractCurves({job.views(), job.scene.images(), job.cache, std::nullopt, on_fragments},
                    job.options.pipeline.edges, job.options.pipeline.linking, job.context());
  job.console->Report(result.summary);
  return result;
}

std::shared_ptr<const std::vector<ImageCurves>> SharedImageCurves(const Job& job) {
  return std::make_shared<const std::vector<ImageCurves>>(ExtractImageCurves(job).curves);
}

}  // namespace limn::colmap_ext
