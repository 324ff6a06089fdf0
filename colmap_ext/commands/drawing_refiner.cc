#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/drawing_input.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/refined_cameras.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/run/trust.h"
#include "limn/belief/link_judge.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/refinement/refinement.h"

namespace limn::colmap_ext {

int RunDrawingRefiner(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  std::string drawing_path;
  const auto parser = ParseRunOptions(
      "drawing_refiner", "fit the drawing that curve_drawer has stored to all images",
      {.linking = true, .refinement = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) {
        more->AddOption("drawing_path", &drawing_path,
                        BasicOption("drawing.json to start from, instead of the one in the "
                                    "output folder"));
      });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckRefinedFolder(project, options);
  CheckDrawingFiles(project, options);
  const bool in_place = drawing_path.empty();
  if (in_place) {
    drawing_path =
        FindDrawing(project.layout().output.drawing_dir, DrawingChoice::kUnfused, "drawing_path");
  }
  const DrawingFile given = ReadDrawingResult(project, drawing_path);
  const std::string provenance = RefinementProvenance(options, given.metadata.options_json);
  if (!in_place) CheckReplaceable(project, options, "drawing.json", provenance);
  const CurvesResult image_curves = ExtractProjectCurves(project, options, console.get());
  const RefinementResult result = RefineDrawing(
      {project.views(), image_curves.curves, given.graph, &project.view_set().hints.points},
      options.pipeline.refinement, options.pipeline.drawing.topology, console->context());
  console->Report(result.summary);
  const std::vector<View>& views = ViewsOfDrawing(project, result.cameras);
  const BeliefResult judged =
      JudgeLinks({views, image_curves.curves, result.graph, result.fitted}, options.pipeline.belief,
                 options.pipeline.drawing.topology, console->context());
  console->Report(judged.summary);
  const PrimitiveResult primitives =
      FitPrimitives(judged.graph, views, options.pipeline.primitives, console->context());
  console->Report(primitives.summary);
  const KindsResult kinds =
      ClassifyKinds({views, project.images().read, primitives.graph}, console->context());
  console->Report(kinds.summary);
  CheckGraph(kinds.graph);
  WriteRefinedModel(project, result.cameras, console.get());
  WriteDrawingResults(project, views, kinds.graph, provenance, given.metadata.alignment,
                      console.get());
  SayTrust(MeasureTrust(views, image_curves.curves, kinds.graph), HasBox(provenance),
           console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
