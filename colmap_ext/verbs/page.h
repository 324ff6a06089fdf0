// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/verbs/page_options.h"
#include "limn/model/alignment.h"
#include "limn/viewer/page_reader.h"
#include "limn/viewer/viewer_scene.h"

namespace limn::colmap_ext {

constexpr const char* kViewerPage = "drawing.html";

struct PageCloud {
  std::vector<ViewerPoint> points;  // in the coordinates of the model
  std::string source;               // CloudSource
};

// What a page has beside a drawing.
struct PageParts {
  PageCloud cloud;
  // Per view.
  std::vector<ViewerThumbnail> thumbnails;
  // See ViewerScene.
  std::string report_json;
};

// Throws IoError, also if the requested cloud does not exist.
PageCloud MakeCloud(const Project& project, const std::string& workspace_path,
                    const PageOptions& options, Console* console);

// The files that MakeCloud reads, with their sizes and times of change: a page with points of
// others needs new ones.
std::string CloudSource(const Project& project, const std::string& workspace_path,
                        const PageOptions& options);

// The photographs of the drawing's views at a size that keeps the page within limits. Those of
// another page are used again where they are of the same camera.
std::vector<ViewerThumbnail> MakeThumbnails(const Project& project, const std::vector<View>& views,
                                            int size, const std::vector<PagePhoto>& known,
                                            Console* console);

// What the page shows of the drawing: in the coordinates of the model, or in the world if there is
// an alignment to show.
ViewerScene MakeViewerScene(const Project& project, const DrawingInScene& drawing,
                            const PageOptions& options, PageParts parts,
                            const std::optional<Alignment>& shown);

// Writes drawing.html beside the drawings of the project. `drawing_path`: the drawing's file.
// Throws IoError, also for a drawing without an alignment whose world is to be shown, and
// InputError.
void WritePage(const Project& project, const DrawingInScene& drawing,
               const std::string& drawing_path, const PageOptions& options, PageParts parts,
               Console* console);

}  // namespace limn::colmap_ext
