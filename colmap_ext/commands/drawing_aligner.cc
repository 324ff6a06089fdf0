#include <filesystem>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/alignment_run.h"
#include "colmap_ext/run/drawing_input.h"
#include "colmap_ext/run/fusion_results.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_options.h"

namespace limn::colmap_ext {

int RunDrawingAligner(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  AlignOptions align;
  std::string drawing_path;
  const auto parser = ParseRunOptions(
      "drawing_aligner", "find up, horizontal axes and scale of a stored drawing", {}, argc, argv,
      &options, [&](OptionParser* more) {
        align.AddOptions(/*of_drawing=*/true, more);
        more->AddOption("drawing_path", &drawing_path,
                        BasicOption("drawing to align, instead of drawing.json (and "
                                    "drawing-fused.json) in the output folder"));
      });
  if (!parser) return 0;
  align.Check();
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  const bool is_named = !drawing_path.empty();
  if (!is_named) {
    drawing_path =
        FindDrawing(project.layout().output.drawing_dir, DrawingChoice::kUnfused, "drawing_path");
  }
  const DrawingFile drawing = ReadDrawingResult(project, drawing_path);
  const SceneAligner aligner(project, options.layout, align, console.get());
  const auto alignment = aligner.Align(project.views(), drawing.graph, console.get());
  std::vector<std::string> paths = {drawing_path};
  // Last, so that it stays the newer one, which drawing_viewer shows.
  const std::string fused = project.DrawingPath(kFusedDrawing);
  if (!is_named && std::filesystem::exists(fused)) paths.push_back(fused);
  StoreAlignment(paths, *alignment);
  for (const std::string& path : paths) console->Say("Written: alignment in " + path);
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
