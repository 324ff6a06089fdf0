// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/files/output_path.h"

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
  // Results that the command continues from, in the output folder or elsewhere (see NewestFile).
  // Empty: it starts from images. Not a user option.
  std::vector<std::string> starts_from = {};

  bool operator==(const LayoutOptions&) const = default;
  // Throws OptionError.
  void Check() const;
};

// Where results go. The folders are not created here.
struct OutputLayout {
  // The folder that the user named: those below are in it, or it is drawing_dir.
  std::filesystem::path named_dir;
  // drawing.ply and the like; beside fused.ply in a dense workspace.
  std::filesystem::path drawing_dir;
  // Cache, sketches, tracks, overlays, project.ini.
  std::filesystem::path curves_dir;

  OutputPath Drawing() const;
  OutputPath Curves() const;
};

struct WorkspaceLayout {
  std::filesystem::path model_dir;  // empty for a model in memory
  // The model of the project: another one if the cameras of model_dir were refined.
  std::filesystem::path given_model_dir;
  std::filesystem::path image_dir;
  // The dense workspace (fused.ply, stereo/); empty if the model does not belong to one.
  std::filesystem::path dense_dir;
  OutputLayout output;
  // What was chosen, in one line for the user.
  std::string description;
  // Where refined cameras are taken from, or why they are not, in one line; empty if what the
  // command starts from fits none.
  std::string note;
};

// Finds model, images and output folders. The workspace W is interpreted as the first of
//   W            W/sparse holds a model and W/images exists (a dense workspace)
//   W/dense/<i>  holds the same; then W/dense itself
//   W/sparse/<i> or W/sparse, with W/images; then the same in W/colmap/sparse (nerfstudio),
//                W/colmap_sparse and W/colmap_text (instant-ngp); W/sparse/<i>/<j> counts, too
//   W/distorted/sparse/<i>  with W/input (gaussian-splatting before it undistorts)
//   W, W/pmvs    a PMVS folder (pmvs_model.h), with its visualize/
//   W/<i> or W   a model itself, with `images` in W, its parent or the parent of that
// Where there is no folder `images`, the first of `input`, `images_2`, `images_4` and `images_8` is
// used. The other paths override the folders found; with image_path, no `images` folder is
// required.
//
// A drawing or sketch that fits refined cameras was written with them, into refined/ of the output
// folder. A command that continues from it takes that model, unless input_path names one.
//
// Throws OptionError if too few paths are given. Throws IoError if nothing matches; it says what
// was found: the options for a model elsewhere, the command that imports cameras of another
// program, or the one that makes a model of a database.
WorkspaceLayout ResolveLayout(const LayoutOptions& options);

// If this drawing or sketch fits refined cameras, and these are in refined/ of the layout's output
// folder or beside it, makes them the model of the layout. Returns whether it does.
bool TakeRefinedCameras(const std::filesystem::path& result, WorkspaceLayout* layout);

// The model of the layout. Throws IoError.
SparseModel ReadModelOf(const WorkspaceLayout& layout);

// The one of these files in a folder, or elsewhere, that was changed last; of several the first.
// Empty if there is none.
std::filesystem::path NewestFile(const std::filesystem::path& folder,
                                 const std::vector<std::string>& names);

// Whether there is a model, maybe incomplete or without its images, where ResolveLayout looks for
// one in a workspace.
bool HoldsSomeModel(const std::filesystem::path& workspace);

// The layout for a model in memory with this many images: only image_path and output_path count.
// Throws OptionError if one is missing, IoError if there is no such folder of images.
WorkspaceLayout LayoutInMemory(const LayoutOptions& options, size_t num_images);

}  // namespace limn::colmap_ext
