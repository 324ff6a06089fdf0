// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "colmap_ext/adapter/colmap_versions.h"
#include "colmap_ext/verbs/draw_options.h"
#include "limn/model/drawing_graph.h"

namespace limn::colmap_ext {

class Project;
class Console;

inline DrawerOptions AtMediumQuality() {
  DrawerOptions options;
  options.run = DefaultRunOptions(Quality::kMedium);
  return options;
}

struct CurveDrawerOptions {
  // Folder that the names of the images are relative to.
  std::string image_path;
  // Folder for drawing.json and all that automatic_drawer writes beside it.
  std::string output_path;
  // The options of automatic_drawer except its paths, at medium quality. For another quality:
  // drawer.run = DefaultRunOptions(Quality::kHigh).
  DrawerOptions drawer = AtMediumQuality();
  // Adds the drawing to the reconstruction as 3D points with tracks, this many pixels apart, seen
  // by the images that support the curves. 0 = off. Not with refined poses, which the
  // reconstruction does not have.
  double point_spacing_px = 0;

  // Logs what is wrong.
  bool Check() const;
};

// Draws a reconstruction as one stage of a program that links COLMAP: what `limn automatic_drawer`
// makes from its files, bit for bit. Progress is logged with LOG(INFO). A stop takes effect at the
// next report of progress, and a pause holds the work there; results for the cache are kept.
//
// Run by a ControllerThread or any thread; up to COLMAP 3.9 it is a Thread itself.
class CurveDrawerController : public ColmapController {
 public:
  // The reconstruction must have been torn down if points are added to it.
  CurveDrawerController(CurveDrawerOptions options,
                        std::shared_ptr<colmap::Reconstruction> reconstruction);

  // Throws nothing: errors are logged with LOG(ERROR) and returned by Error().
  void Run() override;

  // The drawing in the coordinates of the reconstruction. Empty before the end of the run, and if
  // the run failed or was stopped.
  const std::optional<DrawingGraph>& Drawing() const { return drawing_; }
  // Why there is no drawing; empty if it was stopped, or only made a shard.
  const std::string& Error() const { return error_; }

 private:
  void Draw();
  void AddPoints(const Project& project, const DrawingGraph& graph, const Console& console);

  const CurveDrawerOptions options_;
  std::shared_ptr<colmap::Reconstruction> reconstruction_;
  std::optional<DrawingGraph> drawing_;
  std::string error_;
};

}  // namespace limn::colmap_ext
