#include <filesystem>

#include <nlohmann/json.hpp>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/fusion_results.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/results.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/run/viewer_results.h"
#include "limn/formats/json_text.h"
#include "limn/formats/whole_file.h"
#include "limn/util/errors.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// drawing-fused.json, which says more, unless drawing.json has been drawn again since.
std::string NewestDrawing(const Project& project) {
  const std::string drawing = project.DrawingPath("drawing.json");
  const std::string fused = project.DrawingPath(kFusedDrawing);
  if (!fs::exists(fused)) return drawing;
  const bool is_newer =
      !fs::exists(drawing) || fs::last_write_time(fused) >= fs::last_write_time(drawing);
  return is_newer ? fused : drawing;
}

}  // namespace

int RunDrawingViewer(int argc, const char* const* argv) {
  RunOptions options;
  ViewerOptions viewer;
  std::string drawing_path, report_path;
  const auto parser = ParseRunOptions(
      "drawing_viewer", "make a page that shows a stored drawing in a browser", {}, argc, argv,
      &options, [&](OptionParser* more) {
        more->AddOption("drawing_path", &drawing_path,
                        "drawing to show, instead of the newer of drawing.json and "
                        "drawing-fused.json in the output folder");
        more->AddOption("report_path", &report_path,
                        "JSON file with a report of the run, for the tab Report");
        more->AddOption("cloud", &viewer.cloud, {"auto", "sparse", "dense", "none"},
                        "which points to show; auto = dense where there are some");
        more->AddOption("max_points", &viewer.max_points, "thin the points to so many");
        more->AddOption("thumbnail_size", &viewer.thumbnail_size,
                        "longer side of the photographs in the page, px");
      });
  if (!parser) return 0;
  viewer.Check();
  if (!HasViewerPage()) {
    throw InputError("this limn was built without the viewer (CMake option LIMN_WITH_VIEWER)");
  }
  const std::string report = report_path.empty() ? "" : ReadWholeFile(report_path);
  if (!report.empty() && !ParseJson(report_path, report).is_object()) {
    throw IoError(report_path, "must be a JSON object");
  }
  Console console(options.num_threads);
  const Project project(options, &console);
  if (drawing_path.empty()) drawing_path = NewestDrawing(project);
  const DrawingFile drawing = ReadDrawingResult(project, drawing_path);
  console.Say("drawing: " + drawing_path);
  WriteViewerResult(project, options.layout.workspace_path, project.views(), drawing.graph, viewer,
                    report, &console);
  return 0;
}

}  // namespace limn::colmap_ext
