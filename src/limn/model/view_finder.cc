// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/view_finder.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Rounding must not lose a view.
constexpr double kSlack = 1e-9;

Eigen::Matrix<double, 5, 3> InwardNormals(const View& view) {
  const Eigen::Vector3d low = view.camera.RayFromPixel(view.region.min_px);
  const Eigen::Vector3d high = view.camera.RayFromPixel(view.region.max_px);
  Eigen::Matrix<double, 5, 3> normals;
  normals << 1, 0, -low.x(), -1, 0, high.x(), 0, 1, -low.y(), 0, -1, high.y(), 0, 0, 1;
  return normals.rowwise().normalized();
}

}  // namespace

ViewFinder::ViewFinder(const std::vector<View>& views) {
  for (const View& view : views) {
    const Eigen::Matrix<double, 5, 3> normals = InwardNormals(view);
    Planes& planes = planes_.emplace_back();
    planes.leftCols<3>() = normals * view.cam_from_world.rotation.toRotationMatrix();
    planes.col(3) = normals * view.cam_from_world.translation;
  }
}

std::vector<ViewId> ViewFinder::Near(const Eigen::Vector3d& center, double radius) const {
  std::vector<ViewId> near;
  const double reach = radius + kSlack * (center.norm() + radius);
  for (size_t v = 0; v < planes_.size(); ++v) {
    const Eigen::Matrix<double, 5, 1> inwards = planes_[v] * center.homogeneous();
    if (inwards.minCoeff() >= -reach) near.push_back(static_cast<ViewId>(v));
  }
  return near;
}

std::vector<ViewId> ViewFinder::NearAnyOf(const std::vector<Eigen::Vector3d>& points) const {
  if (points.empty()) return {};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  return Near(box.center(), 0.5 * box.diagonal().norm());
}

}  // namespace limn
