// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/refine_cameras.h"

#include <string>

#include "colmap_ext/host/job.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "limn/pipeline/pipeline.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

void RefineCamerasVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  const CameraRefinement how = options.pipeline.refine_cameras;
  if (how == CameraRefinement::kOff) {
    throw OptionError("refine_cameras = 0: there is nothing else to do: auto or 1");
  }
  CheckRefinedFolder(project, options);
  const std::string sketch = SketchFileName(options.pipeline.mode);
  if (!options.overwrite && !CamerasOfResults(project, sketch).empty()) {
    throw IoError(project.DrawingPath("drawing.json").string(),
                  "was made with the cameras in refined/: --overwrite 1 replaces them, "
                  "--output_path writes elsewhere");
  }
  CheckSceneViews(project);
  const Job job = JobOf(project, options, console);
  const std::string why_not = WhyCamerasStay(job);
  if (!why_not.empty()) throw OptionError("cameras cannot be refined: " + why_not);
  const ViewSet& set = project.view_set();
  UnrefinedScene scene = DrawUnrefined(
      {set.views, set.hints, project.images(), SceneBox(project, options), job.cache, &set.mounts},
      options.pipeline, job.context(), job.reporter());
  if (scene.cameras) ToImagePixels(set, &*scene.cameras);
  ToImagePixels(set, &scene.rows);
  SayCameras(scene.cameras, set, how, console);
  SayRows(scene.rows, console);
  if (scene.cameras) {
    WarnOfDense(project, *scene.cameras, console);
    WriteRefinedModel(project, scene.cameras, console);
  } else {
    WriteGivenModel(project, console);
  }
  console->RepeatWarnings();
}

}  // namespace limn::colmap_ext
