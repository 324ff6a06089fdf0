// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

// Collects the records of both file formats and enforces the invariants of a model (listed at
// ReadColmapModel). Order of the calls: all cameras, all images, all points.
class ModelBuilder {
 public:
  void AddCamera(Camera camera, const FilePlace& place);
  // `quaternion` is w, x, y, z as stored; image.cam_from_world.rotation is set from it.
  void AddImage(ModelImage image, const std::array<double, 4>& quaternion, const FilePlace& place);
  // Points that are not finite or have a duplicate id, and track elements of unknown images, are
  // dropped and counted in a warning. Track elements whose 2D point is missing or belongs to
  // another 3D point are kept and counted in another.
  void AddPoint(ModelPoint point);
  void Warn(std::string warning) { model_.warnings.push_back(std::move(warning)); }

  SparseModel Finish();

 private:
  SparseModel model_;
  std::unordered_map<uint32_t, size_t> camera_index_;
  std::unordered_map<uint32_t, size_t> image_index_;
  std::unordered_set<std::string> image_names_;
  std::unordered_set<uint64_t> point_ids_;
  int64_t num_odd_quaternions_ = 0;
  int64_t num_odd_principal_points_ = 0;
  int64_t num_bad_points_ = 0;
  int64_t num_bad_track_elements_ = 0;
  int64_t num_odd_track_elements_ = 0;
};

// Checks a pose as stored and returns it normalized. Throws via `place`.
Rigid3d MakePose(const std::array<double, 4>& quaternion, const Eigen::Vector3d& translation,
                 const std::string& what, const FilePlace& place);

}  // namespace limn::colmap_ext
