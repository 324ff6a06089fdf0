// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/scene.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/workspace/file_identity.h"
#include "colmap_ext/workspace/find_masks.h"
#include "limn/sketch/view_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// To be raised whenever the same file of edges gives other edges.
constexpr int kEdgeFilesVersion = 2;

std::string ImageIdentity(const ViewSet& set, ViewId view) {
  const ViewFile& file = set.files[view];
  std::string identity = "image " + set.photos.Identity(file.image_path);
  if (const auto& window = file.window) {
    identity += "\npart " + std::to_string(window->x) + " " + std::to_string(window->y);
  }
  identity += KeyOf(file.form);
  if (file.is_damaged) identity += "\ndamaged";
  if (!file.mask_path.empty()) identity += "\nmask " + FileIdentity(file.mask_path);
  const PinholeCamera& camera = set.views[view].camera;
  identity += "\nsize " + std::to_string(camera.width) + " " + std::to_string(camera.height);
  // An image that is shrunk first shows less.
  if (set.views[view].scale > 1) identity += "\nread at " + Text(set.ReadSize(view));
  return identity;
}

std::string TextOf(const Eigen::Vector3d& point) {
  char text[100];
  std::snprintf(text, sizeof(text), "(%.10g, %.10g, %.10g)", point.x(), point.y(), point.z());
  return text;
}

// How many images are used smaller than they are, and what that costs. Empty = none.
std::string ShrinkingNote(const ViewSet& set) {
  std::set<std::string> names;
  double stored_pixels = 0;
  double used_pixels = 0;
  for (size_t v = 0; v < set.views.size(); ++v) {
    const auto id = static_cast<ViewId>(v);
    const ImageSize stored = set.files[v].stored_size;
    const ImageSize used = ShrunkSize(stored, set.MaxFileSize(id));
    if (used == stored || !names.insert(set.ImageName(id)).second) continue;
    stored_pixels += static_cast<double>(stored.NumPixels());
    used_pixels += static_cast<double>(used.NumPixels());
  }
  if (names.empty()) return "";
  char factor[40];
  std::snprintf(factor, sizeof(factor), "%.1f", stored_pixels / used_pixels);
  return std::to_string(names.size()) + " images are shrunk to " +
         std::to_string(set.max_image_size) + " px" +
         (set.HasPanoramas() ? " per quarter turn" : "") +
         ", finer detail is not drawn: --max_image_size -1 uses all of their pixels, " + factor +
         " times as many, and that much more time and memory";
}

// Masks that seem to be there. Empty = none.
std::string MasksNote(const fs::path& image_dir) {
  const std::string folder = image_dir.empty() ? "" : MasksBeside(image_dir);
  return folder.empty() ? "" : "NOTE: masks in " + folder + " are not used: --mask_path " + folder;
}

// How many images are used as if enlarged, and how far. Empty = none.
std::string EnlargingNote(const ViewSet& set) {
  int num_enlarged = 0;
  double largest = 1;
  for (const View& view : set.views) {
    num_enlarged += view.scale > 1;
    largest = std::max(largest, view.scale);
  }
  if (num_enlarged == 0) return "";
  char factor[40];
  std::snprintf(factor, sizeof(factor), "%g", largest);
  return std::to_string(num_enlarged) +
         " images resolve more than their pixels show: drawn as if enlarged up to " + factor +
         " times";
}

}  // namespace

Scene::Scene(WorkspaceLayout layout, const RunOptions& options, Console* console)
    : layout_(std::move(layout)) {
  SparseModel model = ReadModelOf(layout_);
  SetModel(std::move(model), {}, options, console);
}

Scene::Scene(SparseModel model, const fs::path& image_dir, const PhotoStore& photos,
             const RunOptions& options, Console* console) {
  layout_.image_dir = image_dir;
  SetModel(std::move(model), photos, options, console);
}

void Scene::SetModel(SparseModel model, const PhotoStore& photos, const RunOptions& options,
                     Console* console) {
  origin_ = SceneOrigin(model);
  MoveModel(-origin_, &model);
  ViewOptions view_options = options.view;
  std::string& mask_path = view_options.mask_path;
  if (mask_path.empty()) mask_path = MaskListOf(layout_.given_model_dir);
  view_set_ = ToViews(model, layout_.image_dir, view_options, console->context(), photos);
  for (const std::string& note : view_set_.notes) console->Say("NOTE: " + note);
  for (const std::string& warning : view_set_.warnings) console->Say("WARNING: " + warning);
  const size_t num_images = view_set_.CountImages(IdsOf(std::nullopt, views().size()));
  console->Say(std::to_string(num_images) + " images" +
               (num_images == views().size()
                    ? ""
                    : " (in " + std::to_string(views().size()) + " views: panoramas in parts)") +
               ", " + std::to_string(view_set_.hints.points.size()) + " 3D points");
  const std::string masks_note = mask_path.empty() ? MasksNote(layout_.image_dir) : "";
  for (const std::string& note : {masks_note, ShrinkingNote(view_set_), EnlargingNote(view_set_)}) {
    if (!note.empty()) console->Say(note);
  }
  if (!origin_.isZero()) {
    console->Say("Coordinates are large: working around " + TextOf(origin_) +
                 ", all files keep the model's coordinates");
  }
  CheckPanoramas(options);
  images_.read = [this](ViewId view) { return ReadViewImage(view_set_, view); };
  images_.release = [this] { ReleaseDecoded(view_set_); };
  images_.identity = [this](ViewId view) { return ImageIdentity(view_set_, view); };
  if (!options.edges_path.empty()) UseEdges(options, console);
}

void Scene::CheckPanoramas(const RunOptions& options) const {
  if (!view_set_.HasPanoramas()) return;
  if (!options.edges_path.empty()) {
    throw OptionError("edges_path = " + options.edges_path +
                      ": the model has EQUIRECTANGULAR images, whose edges are found in parts");
  }
}

void Scene::UseEdges(const RunOptions& options, Console* console) {
  edge_files_ = FindEdgeFiles(options.edges_path, view_set_);
  console->Say("Edges of all images from " + options.edges_path);
  images_.given_edges = [this, maps = options.edge_maps](ViewId view) {
    return ReadEdgeFile(edge_files_[view], view_set_, view, maps);
  };
  const std::string key = "\nedges, version " + std::to_string(kEdgeFilesVersion) + "\n" +
                          OptionsAsText(options.edge_maps);
  images_.identity = [this, key](ViewId view) {
    return ImageIdentity(view_set_, view) + key + FileIdentity(edge_files_[view]);
  };
}

std::optional<Eigen::AlignedBox3d> SceneBox(const Scene& scene, const RunOptions& options) {
  return Moved(BoxFromNumbers(options.box), -scene.origin());
}

void CheckSceneViews(const Scene& scene) {
  try {
    CheckViews(scene.views());
  } catch (const InputError& error) {
    std::string reason = error.what();
    for (const std::string& why : scene.view_set().left_out) reason += "; " + why;
    throw InputError(reason);
  }
}

}  // namespace limn::colmap_ext
