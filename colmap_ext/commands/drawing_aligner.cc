#include <filesystem>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

void CheckStoresAlignment(const std::string& drawing_path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(drawing_path, ignored)) return;
  throw OptionError("drawing_path = " + drawing_path +
                    ": is a folder, where no alignment can be stored; export it to a .json file "
                    "first (drawing_exporter)");
}

}  // namespace

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
  CheckStoresAlignment(drawing_path);
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  const std::vector<std::string> paths =
      drawing_path.empty() ? DrawingsToAlign(project.layout().output.drawing_dir, console.get())
                           : std::vector<std::string>{drawing_path};
  // Known lengths name the links that drawing_viewer shows.
  const DrawingFile drawing = ReadDrawingResult(project, paths.front());
  console->Say("drawing: " + paths.front());
  const SceneAligner aligner(project, options.layout, align, console.get());
  const auto alignment = aligner.Align(project.views(), drawing.graph, console.get());
  StoreAlignment(paths, *alignment);
  for (const std::string& path : paths) console->Say("Written: alignment in " + path);
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
