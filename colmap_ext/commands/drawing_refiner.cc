#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/trust.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

int RunDrawingRefiner(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  std::string drawing_path;
  const auto parser = ParseRunOptions(
      "drawing_refiner", "fit the drawing that curve_drawer has stored to all images",
      {.linking = true, .refinement = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) { AddDrawingPath(&drawing_path, more); });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckRefinedFolder(project, options);
  CheckDrawingFiles(project, options);
  const auto [given, provenance] =
      ReadStartingDrawing(project, options, drawing_path, RefinementProvenance);
  const CurvesResult image_curves = ExtractProjectCurves(project, options, console.get());
  const StageObserver report = [&](const StageSummary& summary) { console->Report(summary); };
  const JudgedDrawing judged = RefineAndJudge(
      {{project.views(), image_curves.curves, project.view_set().hints}, given.graph},
      options.pipeline, console->context(), report);
  const std::vector<View>& views = ViewsOfDrawing(project, judged.cameras);
  const DrawingGraph graph = DescribeLinks(judged.graph, views, project.images().read,
                                           options.pipeline, console->context(), report);
  CheckGraph(graph);
  WriteRefinedModel(project, judged.cameras, console.get());
  WriteDrawingResults(project, views, graph, provenance, given.metadata.alignment, console.get());
  SayTrust(MeasureTrust(project.view_set(), views, image_curves.curves, graph), HasBox(provenance),
           console.get());
  SayDroppedFaces(given.graph, graph, console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
