// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/sketch.h"

#include <utility>

#include "colmap_ext/verbs/drawing_results.h"
#include "limn/pipeline/sketch_views.h"

namespace limn::colmap_ext {

CurveSketch MakeSketch(const Job& job, const std::vector<ImageCurves>& curves) {
  const PipelineOptions& options = job.options.pipeline;
  SketchResult result =
      SketchViews(options.mode, {job.WithCurves(curves)}, options.sketch, job.cache, job.context());
  job.console->Report(result.summary);
  return std::move(result.sketch);
}

void SketchVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckSketchFiles(project, options);
  CheckSceneViews(project);
  const Job job = JobOf(project, options, console);
  const CurvesResult image_curves = ExtractImageCurves(job);
  const CurveSketch sketch = MakeSketch(job, image_curves.curves);
  const std::string name = SketchFileName(options.pipeline.mode);
  WriteSketchResults(project, name, project.views(), image_curves.curves, sketch,
                     Metadata(project, Provenance(options)), job.context());
  console->Say("Written: " + project.CurvesPath(name).string() + ".{bin,ply}");
}

}  // namespace limn::colmap_ext
