#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/view.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/util/errors.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {

int RunDrawingViewer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  ViewerOptions viewer;
  const auto parser =
      ParseRunOptions("drawing_viewer", "make a page that shows a stored drawing in a browser",
                      {.overwrites = true}, argc, argv, &options,
                      [&](OptionParser* more) { viewer.AddOptions(more); });
  if (!parser) return 0;
  viewer.Check();
  if (!HasViewerPage()) {
    throw InputError("this limn was built without the viewer (CMake option LIMN_WITH_VIEWER)");
  }
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const std::string report = ReadReport(viewer);
  const Project project(options, console.get());
  CheckResultFile(project.DrawingPath(kViewerPage), options.overwrite);
  const std::string drawing_path = DrawingToView(project, viewer);
  const DrawingFile drawing = ReadDrawingResult(project, drawing_path);
  console->Say("drawing: " + drawing_path);
  std::optional<Alignment> shown;
  if (viewer.aligned) shown = RequireAlignment(drawing_path, drawing.metadata);
  WriteViewerResult(project, options.layout.workspace_path, project.views(), drawing.graph, viewer,
                    report, shown, console.get());
  return 0;
}

}  // namespace limn::colmap_ext
