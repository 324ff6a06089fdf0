#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "limn/surfaces/find_faces.h"

namespace limn::colmap_ext {

int RunDrawingSurfacer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  std::string drawing_path;
  const auto parser = ParseRunOptions(
      "drawing_surfacer", "find the surfaces that the curves of a stored drawing bound",
      {.linking = true, .surfaces = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) { AddDrawingPath(&drawing_path, more); });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckDrawingFiles(project, options);
  const auto [given, provenance] =
      ReadStartingDrawing(project, options, drawing_path, SurfaceProvenance);
  const CurvesResult image_curves = ExtractProjectCurves(project, options, console.get());
  const SurfaceResult result =
      FindFaces({project.views(), image_curves.curves, project.view_set().hints},
                options.pipeline.refinement.Gate(), given.graph, options.pipeline.surfaces,
                console->context());
  console->Report(result.summary);
  SayLinksBehind(result.links_behind, console.get());
  CheckGraph(result.graph);
  WriteDrawingResults(project, project.views(), result.graph, provenance, given.metadata.alignment,
                      console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
