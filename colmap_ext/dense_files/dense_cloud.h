// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "colmap_ext/dense_files/products.h"
#include "limn/dense/dense_point.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A cloud on disk, read again at every call of `points`.
struct DenseCloud {
  uint64_t num_points = 0;
  bool has_normals = false;
  bool has_visibility = false;
  DensePointStream points;
  // Points that the last call of `points` left out: with a number that is not finite, or farther
  // than 1e15 from the origin. Null if that is unknown.
  std::shared_ptr<const uint64_t> num_odd = nullptr;

  // For the user; empty if none was left out. Call it after `points`.
  std::string NoteOnOdd() const;
};

// fused.ply or any other PLY cloud, with <path>.vis if it exists: the views that see each point, as
// indices into the model's images, of which there are `num_model_images`. Odd points are left out.
// Throws IoError here or
// from `points`: unreadable file, .vis with a different number of points or trailing bytes, an
// image number that the model does not have.
DenseCloud OpenPlyCloud(const std::filesystem::path& path, const std::vector<View>& views,
                        size_t num_model_images);

// PMVS's patches. Images that are not among the views are ignored. Colors are those of the .ply
// file of the same name that PMVS writes beside it, or gray without one. Throws IoError, also for
// image numbers outside the list of images or, without a list, outside the model.
DenseCloud OpenPatchCloud(const std::filesystem::path& path, const std::vector<View>& views,
                          size_t num_model_images);

// The points of several files, each opened by its extension. Precondition: at least one path.
// Throws IoError, also if there are no points.
DenseCloud OpenClouds(const std::vector<std::filesystem::path>& paths,
                      const std::vector<View>& views, size_t num_model_images);

}  // namespace limn::colmap_ext
