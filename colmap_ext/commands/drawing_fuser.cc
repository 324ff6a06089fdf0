#include <optional>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/fuse.h"

namespace limn::colmap_ext {

int RunDrawingFuser(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  FuserOptions fuser;
  const auto parser = ParseRunOptions(
      "drawing_fuser", "compare a stored drawing with dense results and combine the two",
      {.dense = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) { fuser.AddOptions(more); });
  if (!parser) return 0;
  fuser.Check();
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  if (fuser.drawing_path.empty()) {
    fuser.drawing_path =
        FindDrawing(project.layout().output.drawing_dir, DrawingChoice::kUnfused, "drawing_path");
  }
  DrawingFile drawing = ReadDrawingResult(project, fuser.drawing_path);
  drawing.metadata.options_json = FusionProvenance(options, fuser, drawing.metadata.options_json);
  CheckReplaceable(project, options, kFusedDrawing, drawing.metadata.options_json);
  CheckFusionFiles(project, options);
  const DenseInput dense =
      OpenDenseInput(project, fuser, options.layout.workspace_path, console.get());
  FusionResult result = FuseDrawing({project.views(), drawing.graph, dense.depths,
                                     dense.cloud ? std::optional(dense.points) : std::nullopt},
                                    options.dense, console->context());
  console->Report(result.summary);
  SayLengths(result, options.dense, console.get());
  ColorCurvePoints(project, console->context(), &result.points);
  WriteFusionResults(project, options, fuser, dense, drawing.metadata, result, console.get());
  return 0;
}

}  // namespace limn::colmap_ext
