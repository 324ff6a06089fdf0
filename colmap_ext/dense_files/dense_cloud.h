#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/dense_files/products.h"
#include "limn/dense/dense_point.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A cloud on disk, read anew at every call of `points`.
struct DenseCloud {
  uint64_t num_points = 0;
  bool has_normals = false;
  bool has_visibility = false;
  DensePointStream points;
};

// fused.ply or any other PLY cloud, with <path>.vis if it is there: the views that see each point,
// by the order of the model's images. `num_model_images` is the number of images in the model.
// Throws IoError here or from `points`: not readable, another number of points in .vis than in the
// cloud, bytes after them, an image number that the model does not have.
DenseCloud OpenPlyCloud(const std::filesystem::path& path, const std::vector<View>& views,
                        size_t num_model_images);

// PMVS's patches. Images that are not among the views are left out. Colors are those of the .ply
// file of the same name beside it, as PMVS writes it, or gray without one.
// Throws IoError, also for image numbers that neither the list of images nor, without one, the
// model has.
DenseCloud OpenPatchCloud(const std::filesystem::path& path, const std::vector<View>& views,
                          size_t num_model_images);

// All points of several files, each by its extension; at least one. Throws IoError, also when there
// are none.
DenseCloud OpenClouds(const std::vector<std::filesystem::path>& paths,
                      const std::vector<View>& views, size_t num_model_images);

}  // namespace limn::colmap_ext
