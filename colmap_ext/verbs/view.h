#pragma once

#include <optional>
#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/model/alignment.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

// The options of drawing_viewer.
struct ViewerOptions {
  // Empty: the newest drawing in the output folder.
  std::string drawing_path;
  // JSON file for the tab Report; empty: none.
  std::string report_path;
  // "auto" (the first of the others that exists), "dense", "sparse" or "none".
  std::string cloud = "auto";
  int max_points = 200000;
  int thumbnail_size = 320;
  // Show world coordinates, by the alignment of the drawing, instead of the model's.
  bool aligned = false;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

constexpr const char* kViewerPage = "drawing.html";

// Path of the drawing to show, by default the newest one. Throws IoError if there is none.
std::string DrawingToView(const Project& project, const ViewerOptions& options);

// The text of the report; empty if none is given. Throws IoError.
std::string ReadReport(const ViewerOptions& options);

// Writes drawing.html beside the drawing. The graph and `views`, the cameras that it fits, are
// relative to the project's origin; the page is in the coordinates of the model, or in the world if
// there is an alignment to show. `report_json`: see ViewerScene. Throws IoError, also if the
// requested cloud does not exist, and InputError.
void WriteViewerResult(const Project& project, const std::string& workspace_path,
                       const std::vector<View>& views, const DrawingGraph& graph,
                       const ViewerOptions& options, const std::string& report_json,
                       const std::optional<Alignment>& shown, Console* console);

}  // namespace limn::colmap_ext
