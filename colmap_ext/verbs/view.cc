// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/view.h"

#include <nlohmann/json.hpp>

#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/renew_page.h"
#include "colmap_ext/verbs/selection_options.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

// Empty if none is given. Throws IoError.
std::string ReadReport(const std::string& path) {
  if (path.empty()) return "";
  std::string report = ReadWholeFile(path, kMaxJsonBytes);
  if (!report.empty() && !ParseJson(path, report).is_object()) {
    throw IoError(path, "must be a JSON object");
  }
  return report;
}

}  // namespace

void ViewVerb::AddOptions(OptionParser* parser) {
  parser->AddOption("drawing_path", &drawing_path_,
                    BasicOption("drawing to show, instead of the newer of drawing.json and "
                                "drawing-fused.json in the output folder"));
  parser->AddOption("report_path", &report_path_,
                    "JSON file with a report of the run, for the tab Report, instead of that of "
                    "the page before");
  parser->AddOption("cloud", &page_.cloud, {"auto", "sparse", "dense", "none"},
                    BasicOption("which points to show; auto = dense if there are any"));
  parser->AddOption("max_points", &page_.max_points,
                    BasicOption("thin the points to at most this many"));
  parser->AddOption("thumbnail_size", &page_.thumbnail_size,
                    BasicOption("longer side of the photographs in the page, px; fewer where the "
                                "page would be too large"));
  AddDetailOption("the page shows at first", &page_.detail, parser);
  parser->AddOption("aligned", &page_.shown,
                    {{"auto", PageOptions::Shown::kAuto},
                     {"0", PageOptions::Shown::kModel},
                     {"1", PageOptions::Shown::kWorld}},
                    BasicOption("show the world, as drawing_aligner or --align auto found it (1), "
                                "or the coordinates of the model (0); auto = the world if the "
                                "drawing has an alignment"));
}

void ViewVerb::Prepare(RunOptions*, Console*) {
  page_.Check();
  if (!HasViewerPage()) {
    throw InputError("this limn was built without the viewer (CMake option LIMN_WITH_VIEWER)");
  }
  report_json_ = ReadReport(report_path_);
}

std::vector<std::string> ViewVerb::StartsFrom(const RunOptions&) const {
  return DrawingsToStartFrom(DrawingChoice::kNewest, drawing_path_);
}

void ViewVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckResultFile(project.DrawingPath(kViewerPage), options.overwrite);
  const std::string path = !drawing_path_.empty()
                               ? drawing_path_
                               : FindDrawing(project.layout().output.drawing_dir,
                                             DrawingChoice::kNewest, "drawing_path");
  const DrawingInScene drawing = ReadDrawingInScene(project, path);
  console->Say("drawing: " + path);
  PageParts parts;
  parts.report_json = report_path_.empty() ? ReportOfPage(project, console) : report_json_;
  parts.cloud = MakeCloud(project, options.layout.workspace_path, page_, console);
  parts.thumbnails = MakeThumbnails(project, drawing.views, page_.thumbnail_size, {}, console);
  WritePage(project, drawing, path, page_, std::move(parts), console);
}

}  // namespace limn::colmap_ext
