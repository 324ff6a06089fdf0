#pragma once

#include <filesystem>
#include <string>

namespace limn::colmap_ext {

// The path options of a command. Empty = not given.
struct LayoutOptions {
  // Folder of the COLMAP project. Optional if the other three paths are given.
  std::string workspace_path;
  // Folder of the sparse model (cameras, images, points3D) instead of the one found.
  std::string input_path;
  // Folder of the images instead of the one found.
  std::string image_path;
  // Output folder, instead of the one beside the dense results.
  std::string output_path;
  // Which of several models: the <i> of dense/<i> or sparse/<i>. -1 = the one with the most
  // registered images (the lowest number on ties).
  int model_index = -1;

  bool operator==(const LayoutOptions&) const = default;
  // Throws OptionError.
  void Check() const;
};

// Where results go. The folders are not created here.
struct OutputLayout {
  // drawing.ply and the like; beside fused.ply in a dense workspace.
  std::filesystem::path drawing_dir;
  // Cache, sketches, tracks, overlays, project.ini.
  std::filesystem::path curves_dir;
};

struct WorkspaceLayout {
  std::filesystem::path model_dir;  // empty for a model in memory
  std::filesystem::path image_dir;
  // The dense workspace (fused.ply, stereo/); empty if the model does not belong to one.
  std::filesystem::path dense_dir;
  OutputLayout output;
  // What was chosen, in one line for the user.
  std::string description;
};

// Finds model, images and output folders. The workspace W is interpreted as the first of
//   W            W/sparse holds a model and W/images exists (a dense workspace)
//   W/dense/<i>  holds the same; then W/dense itself
//   W/sparse/<i> or W/sparse, with W/images; then the same in W/colmap/sparse
//   W, W/pmvs    a PMVS folder (pmvs_model.h), with its visualize/
//   W/<i> or W   a model itself, with `images` in W, its parent or the parent of that
// The other paths override the folders found; with image_path, no `images` folder is required.
//
// Throws OptionError if too few paths are given, IoError saying what was found if nothing matches.
WorkspaceLayout ResolveLayout(const LayoutOptions& options);

// Whether there is a model, maybe incomplete or without its images, where ResolveLayout looks for
// one in a workspace.
bool HoldsSomeModel(const std::filesystem::path& workspace);

// The layout for a model in memory with this many images: only image_path and output_path count.
// Throws OptionError if one is missing, IoError if there is no such folder of images.
WorkspaceLayout LayoutInMemory(const LayoutOptions& options, size_t num_images);

}  // namespace limn::colmap_ext
