// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/scene_reach.h"

#include <algorithm>

#include "limn/geometry/median_point.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

constexpr double kFarOutside = 1e5;

}  // namespace

SceneReach::SceneReach(const SparseModel& model, const std::vector<int>& images) {
  std::vector<Eigen::Vector3d> centers;
  for (const int image : images) {
    centers.push_back(Inverse(model.images[image].cam_from_world).translation);
  }
  middle_ = MedianPoint(centers);
  std::vector<double> to_cameras, to_points;
  for (const Eigen::Vector3d& center : centers)
    to_cameras.push_back((center - middle_).stableNorm());
  for (const ModelPoint& point : model.points) {
    to_points.push_back((point.position - middle_).stableNorm());
  }
  radius_ = kFarOutside * std::max(Median(std::move(to_cameras)), Median(std::move(to_points)));
}

bool SceneReach::Contains(const Eigen::Vector3d& place) const {
  return radius_ == 0 || (place - middle_).stableNorm() <= radius_;
}

}  // namespace limn::colmap_ext
