#pragma once

#include <optional>
#include <string>

#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/verbs/verb.h"
#include "limn/model/alignment.h"
#include "limn/model/link_selection.h"
#include "limn/viewer/viewer_scene.h"

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
  // Shown at first.
  Detail detail = Detail::kNormal;
  // Show world coordinates, by the alignment of the drawing, instead of the model's.
  bool aligned = false;
};

constexpr const char* kViewerPage = "drawing.html";

// drawing_viewer: a page that shows a stored drawing.
class ViewVerb : public Verb {
 public:
  OptionGroups Groups() const override { return {.overwrites = true}; }
  void AddOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  std::vector<std::string> StartsFrom(const RunOptions& options) const override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  ViewerOptions viewer_;
  // The text of the report; empty if none is given.
  std::string report_json_;
};

// What the page shows of a drawing, but the report: in the coordinates of the model, or in the
// world if there is an alignment to show. Throws IoError, also if the requested cloud does not
// exist, and InputError.
ViewerScene MakeViewerScene(const Project& project, const std::string& workspace_path,
                            const DrawingInScene& drawing, const ViewerOptions& options,
                            const std::optional<Alignment>& shown, Console* console);

// Writes it as drawing.html beside the drawing. `report_json`: see ViewerScene. Throws what
// MakeViewerScene throws.
void WriteViewerResult(const Project& project, const std::string& workspace_path,
                       const DrawingInScene& drawing, const ViewerOptions& options,
                       const std::string& report_json, const std::optional<Alignment>& shown,
                       Console* console);

}  // namespace limn::colmap_ext
