// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/camera_rays.h"

#include <optional>

#include <Eigen/Geometry>

namespace limn {
namespace {

// Pixels of an image that are compared, along each side.
constexpr int kGridSize = 9;

std::optional<Eigen::Vector3d> Ray(const View& view, const Eigen::Vector2d& stored_px) {
  const auto virtual_px = view.VirtualFromStored(stored_px);
  if (!virtual_px) return std::nullopt;
  return view.camera.RayFromPixel(*virtual_px).normalized();
}

}  // namespace

RayPairs RaysThroughSamePixels(const View& first, const View& second) {
  const Eigen::Vector2d size(first.camera.width, first.camera.height);
  constexpr int kNumPixels = kGridSize * kGridSize;
  RayPairs rays = {Eigen::Matrix3Xd(3, kNumPixels), Eigen::Matrix3Xd(3, kNumPixels)};
  int count = 0;
  for (int i = 0; i < kNumPixels; ++i) {
    const int row = i / kGridSize;
    const Eigen::Vector2d cell(i % kGridSize + 0.5, row + 0.5);
    const Eigen::Vector2d pixel = size.cwiseProduct(cell) / kGridSize;
    const auto ray = Ray(first, pixel);
    const auto other = Ray(second, pixel);
    if (!ray || !other) continue;
    rays.first.col(count) = *ray;
    rays.second.col(count) = *other;
    ++count;
  }
  rays.first.conservativeResize(Eigen::NoChange, count);
  rays.second.conservativeResize(Eigen::NoChange, count);
  return rays;
}

View WithRaysInOpticsOf(const View& other, View view) {
  const RayPairs rays = RaysThroughSamePixels(view, other);
  if (rays.first.cols() == 0) return view;
  const auto with_opposites = [](const Eigen::Matrix3Xd& directions) {
    Eigen::Matrix3Xd both(3, 2 * directions.cols());
    both << directions, -directions;
    return both;
  };
  // Opposite rays have their mean at the center, so that the fit does not move it.
  const Eigen::Matrix4d turn =
      Eigen::umeyama(with_opposites(rays.first), with_opposites(rays.second), false);
  Rigid3d motion;
  motion.rotation = Eigen::Quaterniond(Eigen::Matrix3d(turn.topLeftCorner<3, 3>())).normalized();
  view.cam_from_world = motion * view.cam_from_world;
  return view;
}

}  // namespace limn
