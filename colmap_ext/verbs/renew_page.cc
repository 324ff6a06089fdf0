// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/renew_page.h"

#include <filesystem>
#include <utility>

#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/page.h"
#include "limn/util/errors.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

bool HasPage(const Project& project) {
  std::error_code ignored;
  return fs::exists(project.DrawingPath(kViewerPage).string(), ignored);
}

void Renew(const Project& project, const std::string& workspace_path, Console* console) {
  if (!HasViewerPage()) throw InputError("this limn was built without the viewer");
  StoredPage page = ReadViewerPage(project.DrawingPath(kViewerPage).string());
  const PageOptions options = OptionsOf(page);
  const std::string path =
      FindDrawing(project.layout().output.drawing_dir, DrawingChoice::kNewest, "drawing_path");
  const DrawingInScene drawing = ReadDrawingInScene(project, path);
  const bool is_new = page.drawing.name == fs::path(path).filename() &&
                      page.drawing.fingerprint == drawing.fingerprint;
  if (is_new) return;
  auto thumbnails =
      MakeThumbnails(project, drawing.views, options.thumbnail_size, page.photos, console);
  PageCloud cloud = {std::move(page.cloud), CloudSource(project, workspace_path, options)};
  if (cloud.source != CloudSourceOf(page)) {
    cloud = MakeCloud(project, workspace_path, options, console);
  }
  WritePage(project, drawing, path, options,
            {std::move(cloud), std::move(thumbnails), std::move(page.report_json)}, console);
}

void SayOldPage(const Project& project, std::string reason, Console* console) {
  const std::string path = project.DrawingPath(kViewerPage).string();
  if (reason.starts_with(path + ": ")) reason.erase(0, path.size() + 2);
  console->Say("WARNING: " + path + " is older than the drawing, and was not renewed (" + reason +
               "): drawing_viewer makes it anew");
}

}  // namespace

void RenewPage(const Project& project, const std::string& workspace_path, Console* console) {
  if (!HasPage(project)) return;
  try {
    Renew(project, workspace_path, console);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    SayOldPage(project, error.what(), console);
  }
}

void WarnOfOldPage(const Project& project, const std::string& reason, Console* console) {
  if (HasPage(project)) SayOldPage(project, reason, console);
}

std::string ReportOfPage(const Project& project, Console* console) {
  if (!HasPage(project)) return "";
  try {
    return ReadViewerPage(project.DrawingPath(kViewerPage).string()).report_json;
  } catch (const IoError& error) {
    console->Say("WARNING: the report of the old page is lost: " + std::string(error.what()));
    return "";
  }
}

}  // namespace limn::colmap_ext
