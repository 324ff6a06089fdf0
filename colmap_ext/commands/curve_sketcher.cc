#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "limn/pipeline/sketch_views.h"

namespace limn::colmap_ext {

int RunCurveSketcher(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  const auto parser =
      ParseRunOptions("curve_sketcher", "reconstruct 3D curves: the curve sketch",
                      {.linking = true, .sketch = true, .overwrites = true}, argc, argv, &options);
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckSketchFiles(project, options);
  CheckSceneViews(project);
  const CurvesResult image_curves = ExtractProjectCurves(project, options, console.get());

  const CurvesScene scene = {project.views(), image_curves.curves, project.view_set().hints,
                             SceneBox(project, options)};
  const SketchMode mode = options.pipeline.mode;
  const SketchResult result =
      SketchViews(mode, {scene}, options.pipeline.sketch, project.cache(), console->context());
  console->Report(result.summary);

  const std::string name = SketchFileName(mode);
  WriteSketchResults(project, name, image_curves.curves, result.sketch, Provenance(options),
                     console->context());
  console->Say("Written: " + project.CurvesPath(name) + ".{bin,ply}");
  return 0;
}

}  // namespace limn::colmap_ext
