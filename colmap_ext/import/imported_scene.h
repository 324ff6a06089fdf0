// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/tracked_points.h"
#include "colmap_ext/workspace/image_size.h"

namespace limn::colmap_ext {

// Where a format places pixel centers.
enum class PixelCenters {
  kInteger,  // the center of the top-left pixel is (0, 0): half a pixel is added for COLMAP
  kHalf,     // it is (0.5, 0.5), as in COLMAP
};

// An image with its camera, as read.
struct ImportedImage {
  std::string name;  // relative to the image folder
  // Has no id. The principal point is in the pixels of the format, origin at the top left.
  Camera camera;
  Rigid3d cam_from_world;
  // In the pixels of the format.
  std::vector<Observation> observations;
  // Where in the file it was found, for messages.
  std::string path;
  const char* unit = "line";
  uint64_t number = 1;
  // That of the image file, if it may differ from the camera's; else zero.
  ImageSize file_size = {};
  // The file of its mask, if the format names one; empty: none.
  std::string mask = "";
};

// The content of another program's file, in COLMAP's axes (x right, y down, z forward).
struct ImportedScene {
  std::vector<ImportedImage> images;
  // Tracks refer to images by index + 1.
  std::vector<ModelPoint> points;
  // For the user: which file was read, how images were matched, what was skipped.
  std::vector<std::string> notes;
};

// Sets the points of a scene. Precondition: their tracks refer to its images.
void SetPoints(TrackedPoints tracked, ImportedScene* scene);

struct SparseModelOptions {
  PixelCenters pixel_centers = PixelCenters::kHalf;
  // Images of the same size share the camera of the first of them if that moves no pixel by more
  // than this (pinhole part), and if their distortion parameters agree to 1e-10.
  double share_cameras_px = 1e-7;
};

// The model of a scene; image ids start at 1. Throws IoError with the place of the image for
// everything that ReadModel rejects: duplicate names, focal lengths that are not positive,
// non-finite numbers.
SparseModel ToSparseModel(ImportedScene scene, const SparseModelOptions& options);

}  // namespace limn::colmap_ext
