#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/run/console.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/workspace/edge_files.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/output_lock.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/pipeline/extract_curves.h"

namespace limn::colmap_ext {

// A COLMAP project that has been read: its folders, views and photographs.
class Project {
 public:
  // Finds and reads the model and the headers of all images, finds their files of edges if there is
  // a folder of such, and prints what was chosen. Throws
  // OptionError, IoError and InputError. Writes only the lock file, which keeps other commands (for
  // a shard: all but other shards) out of the output folder during the lifetime of the project.
  // Removes temporary files of a killed run, unless other shards may be running.
  Project(const RunOptions& options, Console* console);
  Project(const Project&) = delete;
  Project& operator=(const Project&) = delete;

  const WorkspaceLayout& layout() const { return layout_; }
  const ViewSet& view_set() const { return view_set_; }
  const std::vector<View>& views() const { return view_set_.views; }
  const ImageSource& images() const { return images_; }
  // Subtracted from all positions of the model (see SceneOrigin): views, hints and everything
  // computed from them are relative to it. Files store the model's coordinates.
  const Eigen::Vector3d& origin() const { return origin_; }

  // Image curves and sketches stored for later runs.
  ResultCache* cache() const { return cache_.get(); }
  // The files of edges of all views, to be used instead of detected ones; empty = detect them.
  const std::vector<std::string>& edge_files() const { return edge_files_; }
  // Path of a file beside fused.ply.
  std::string DrawingPath(const std::string& name) const;
  // Path of a file in the folder of curves.
  std::string CurvesPath(const std::string& name) const;

 private:
  // Throws OptionError for what cannot be done with them.
  void CheckPanoramas(const RunOptions& options) const;
  void UseEdges(const RunOptions& options, Console* console);

  WorkspaceLayout layout_;
  std::optional<OutputLock> lock_;
  std::shared_ptr<ResultCache> cache_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  ViewSet view_set_;
  std::vector<std::string> edge_files_;
  ImageSource images_;
};

// The box of the options, relative to the project's origin; nothing if none was given.
std::optional<Eigen::AlignedBox3d> ProjectBox(const Project& project, const RunOptions& options);

// Throws InputError if nothing can be triangulated from the views (see CheckViews); names the
// images that were left out.
void CheckProjectViews(const Project& project);

// The image curves of all views, from the project's cache where possible; prints a summary.
CurvesResult ExtractProjectCurves(const Project& project, const RunOptions& options,
                                  Console* console, const FragmentsObserver& on_fragments = {});

}  // namespace limn::colmap_ext
