// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_lens_map.h"

namespace limn::colmap_ext {
namespace {

// COLMAP's origin is the corner of the top-left pixel, Limn's its center.
const Eigen::Vector2d kHalfPixel(0.5, 0.5);

}  // namespace

PinholeCamera VirtualPinhole(const Intrinsics& intrinsics, int width, int height) {
  PinholeCamera camera;
  camera.fx = intrinsics.fx;
  camera.fy = intrinsics.fy;
  camera.cx = intrinsics.cx - kHalfPixel.x();
  camera.cy = intrinsics.cy - kHalfPixel.y();
  camera.width = width;
  camera.height = height;
  return camera;
}

std::optional<Eigen::Vector2d> CameraLensMap::VirtualFromStored(
    const Eigen::Vector2d& stored_px) const {
  const auto ray = projection_.RayFromPixel(stored_px + kHalfPixel);
  if (!ray) return std::nullopt;
  const Intrinsics& k = projection_.intrinsics();
  return Eigen::Vector2d(k.fx * ray->x() + k.cx, k.fy * ray->y() + k.cy) - kHalfPixel;
}

std::optional<Eigen::Vector2d> CameraLensMap::StoredFromVirtual(
    const Eigen::Vector2d& virtual_px) const {
  const Intrinsics& k = projection_.intrinsics();
  const Eigen::Vector2d corner_px = virtual_px + kHalfPixel;
  const auto pixel =
      projection_.PixelFromRay({(corner_px.x() - k.cx) / k.fx, (corner_px.y() - k.cy) / k.fy});
  if (!pixel) return std::nullopt;
  return *pixel - kHalfPixel;
}

}  // namespace limn::colmap_ext
