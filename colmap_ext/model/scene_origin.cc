// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/scene_origin.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

// Cameras this much farther from the origin than from each other lose three decimal digits.
constexpr double kFarAway = 1000;

std::vector<Eigen::Vector3d> CentersOf(const SparseModel& model) {
  std::vector<Eigen::Vector3d> centers;
  for (const ModelImage& image : model.images) {
    centers.push_back(Inverse(image.cam_from_world).translation);
  }
  return centers;
}

Eigen::Vector3d MiddleOf(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> values(points.size());
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [&](const Eigen::Vector3d& point) { return point[axis]; });
    middle[axis] = Median(values);
  }
  return middle;
}

}  // namespace

Eigen::Vector3d MiddleOfCameras(const SparseModel& model) { return MiddleOf(CentersOf(model)); }

Eigen::Vector3d SceneOrigin(const SparseModel& model) {
  if (model.images.empty()) return Eigen::Vector3d::Zero();
  const std::vector<Eigen::Vector3d> centers = CentersOf(model);
  const Eigen::Vector3d middle = MiddleOf(centers);
  std::vector<double> values(centers.size());
  std::transform(centers.begin(), centers.end(), values.begin(),
                 [&](const Eigen::Vector3d& center) { return (center - middle).norm(); });
  const double extent = Median(values);
  // Centers that differ by rounding only are one center, which CheckViews must see.
  const bool is_one_center = !(extent > 1e-9 * middle.norm());
  if (is_one_center || middle.norm() <= kFarAway * extent) return Eigen::Vector3d::Zero();
  const double step = std::pow(10, std::ceil(std::log10(extent)));
  return (middle / step).array().round() * step;
}

// In extended precision: the product is millions, its difference from the translation a few units.
Rigid3d Moved(const Rigid3d& cam_from_world, const Eigen::Vector3d& shift) {
  using Extended = long double;
  const Eigen::Quaternion<Extended> rotation = cam_from_world.rotation.cast<Extended>();
  const Eigen::Matrix<Extended, 3, 1> translation =
      cam_from_world.translation.cast<Extended>() -
      rotation.toRotationMatrix() * shift.cast<Extended>();
  return {cam_from_world.rotation, translation.cast<double>()};
}

void MoveModel(const Eigen::Vector3d& shift, SparseModel* model) {
  for (ModelImage& image : model->images) image.cam_from_world = Moved(image.cam_from_world, shift);
  for (Frame& frame : model->frames) frame.rig_from_world = Moved(frame.rig_from_world, shift);
  for (ModelPoint& point : model->points) point.position += shift;
}

}  // namespace limn::colmap_ext
