// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/workspace/edge_files.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/pipeline/extract_curves.h"

namespace limn::colmap_ext {

// The input of a run: views and photographs. Writes nothing.
class Scene {
 public:
  // Reads the model and the headers of all images, finds their edge files if a folder of them is
  // given, and reports what was found. Throws OptionError, IoError and InputError.
  Scene(WorkspaceLayout layout, const RunOptions& options, Console* console);
  // The same for a model in memory, with photographs in the folder or in memory. Throws
  // OptionError, IoError and InputError.
  Scene(SparseModel model, const std::filesystem::path& image_dir, const PhotoStore& photos,
        const RunOptions& options, Console* console);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // For a model in memory, only the folder of images is set.
  const WorkspaceLayout& layout() const { return layout_; }
  const ViewSet& view_set() const { return view_set_; }
  const std::vector<View>& views() const { return view_set_.views; }
  const ImageSource& images() const { return images_; }
  // Subtracted from all positions of the model (see SceneOrigin): views, hints and everything
  // computed from them are relative to it. Files store the model's coordinates.
  const Eigen::Vector3d& origin() const { return origin_; }
  // The edge files of all views, used instead of detection; empty = detect edges.
  const std::vector<std::string>& edge_files() const { return edge_files_; }

 private:
  void SetModel(SparseModel model, const PhotoStore& photos, const RunOptions& options,
                Console* console);
  // Throws OptionError for options that do not work with panoramas.
  void CheckPanoramas(const RunOptions& options) const;
  void UseEdges(const RunOptions& options, Console* console);

  WorkspaceLayout layout_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  ViewSet view_set_;
  std::vector<std::string> edge_files_;
  ImageSource images_;
};

// The box of the options, relative to the scene's origin; nothing if none was given.
std::optional<Eigen::AlignedBox3d> SceneBox(const Scene& scene, const RunOptions& options);

// Throws InputError if nothing can be triangulated from the views (see CheckViews); names the
// images that were left out.
void CheckSceneViews(const Scene& scene);

}  // namespace limn::colmap_ext
