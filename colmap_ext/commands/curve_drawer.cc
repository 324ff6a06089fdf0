#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/trust.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

int RunCurveDrawer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  AlignOptions align;
  const auto parser = ParseRunOptions(
      "curve_drawer", "make the 3D drawing from the sketch that curve_sketcher has stored",
      {.linking = true, .drawing = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) { align.AddOptions(/*of_drawing=*/false, more); });
  if (!parser) return 0;
  align.Check();
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckDrawingFiles(project, options);
  const SceneAligner aligner(project, options.layout, align, console.get());
  const CurvesResult image_curves = ExtractProjectCurves(project, options, console.get());
  const StoredCurveSketch stored = ReadSketchResult(project, SketchFileName(options.pipeline.mode),
                                                    image_curves.curves, console->context());
  const std::string provenance = DrawingProvenance(options, stored.metadata.options_json);
  CheckReplaceable(project, options, "drawing.json", provenance);
  const DrawingResult result = DrawSketch(
      {{project.views(), image_curves.curves, project.view_set().hints, SceneBox(project, options)},
       stored.sketch},
      options.pipeline, console->context());
  console->Report(result.summary);
  CheckGraph(result.graph);
  WriteRefinedModel(project, std::nullopt, console.get());
  WriteDrawingResults(project, project.views(), result.graph, provenance,
                      aligner.Align(project.views(), result.graph, console.get()), console.get());
  SayTrust(MeasureTrust(project.view_set(), project.views(), image_curves.curves, result.graph),
           HasBox(provenance), console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
