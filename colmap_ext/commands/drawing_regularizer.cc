#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "limn/regularity/regularize.h"

namespace limn::colmap_ext {

int RunDrawingRegularizer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  std::string drawing_path;
  const auto parser = ParseRunOptions(
      "drawing_regularizer", "make a stored drawing regular: parallel, at right angles, in planes",
      {.regularities = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) { AddDrawingPath(&drawing_path, more); });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckDrawingFiles(project, options);
  const auto [given, provenance] =
      ReadStartingDrawing(project, options, drawing_path, RegularityProvenance);
  const RegularityResult result =
      Regularize(given.graph, project.views(), options.pipeline.regularity,
                 options.pipeline.primitives, console->context());
  console->Report(result.summary);
  CheckGraph(result.graph);
  SayRegularities(result.graph, result.moves, console.get());
  SayDroppedFaces(given.graph, result.graph, console.get());
  WriteDrawingResults(project, project.views(), result.graph, provenance, given.metadata.alignment,
                      console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
