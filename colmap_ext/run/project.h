#pragma once

#include <memory>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "colmap_ext/run/console.h"
#include "colmap_ext/run/run_options.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/output_lock.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/pipeline/extract_curves.h"

namespace limn::colmap_ext {

// A COLMAP project that has been read: where things are, the views, and their photographs.
class Project {
 public:
  // Finds and reads the model and the headers of all images, and says what was chosen. Throws
  // OptionError, IoError and InputError; nothing is written but the file of the lock, which keeps
  // other commands away from the output folder as long as the project lives, but for other shards
  // where it is one. Temporary files of a run that was killed there are removed, unless shards may
  // be at work.
  Project(const RunOptions& options, Console* console);
  Project(const Project&) = delete;
  Project& operator=(const Project&) = delete;

  const WorkspaceLayout& layout() const { return layout_; }
  const ViewSet& view_set() const { return view_set_; }
  const std::vector<View>& views() const { return view_set_.views; }
  const ImageSource& images() const { return images_; }
  // Views and hints are the model's with this subtracted from all positions (see SceneOrigin), and
  // so is all that is computed from them; files hold the model's coordinates.
  const Eigen::Vector3d& origin() const { return origin_; }

  // Image curves and sketches that runs leave for later ones.
  ResultCache* cache() const { return cache_.get(); }
  // A file beside fused.ply.
  std::string DrawingPath(const std::string& name) const;
  // A file in the folder of curves.
  std::string CurvesPath(const std::string& name) const;

 private:
  WorkspaceLayout layout_;
  std::optional<OutputLock> lock_;
  std::shared_ptr<ResultCache> cache_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  ViewSet view_set_;
  ImageSource images_;
};

// The box of the options around the project's origin; nothing if none was given.
std::optional<Eigen::AlignedBox3d> ProjectBox(const Project& project, const RunOptions& options);

// The image curves of all views, from the project's cache where it holds them; reports what was
// done.
CurvesResult ExtractProjectCurves(const Project& project, const RunOptions& options,
                                  Console* console);

}  // namespace limn::colmap_ext
