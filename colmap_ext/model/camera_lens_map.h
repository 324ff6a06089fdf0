// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "colmap_ext/model/camera_projection.h"
#include "limn/geometry/pinhole_camera.h"
#include "limn/model/lens_map.h"

namespace limn::colmap_ext {

// The virtual pinhole of a COLMAP camera: its focal lengths and principal point, the latter shifted
// to Limn's pixels (center of the top-left pixel at (0, 0)).
PinholeCamera VirtualPinhole(const Intrinsics& intrinsics, int width, int height);

// The lens of a COLMAP camera between the stored image and its virtual pinhole.
class CameraLensMap : public LensMap {
 public:
  explicit CameraLensMap(Intrinsics intrinsics) : projection_(std::move(intrinsics)) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored_px) const override;
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override;

 private:
  CameraProjection projection_;
};

}  // namespace limn::colmap_ext
