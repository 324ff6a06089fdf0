// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

namespace limn {

// The map between the image as stored (with lens distortion) and the view's virtual pinhole image,
// both in pixels with the center of the top-left pixel at (0, 0). Implementations are immutable and
// safe to call from several threads; they return nothing where the lens model is not invertible or
// the ray is more than 75 degrees off the optical axis.
class LensMap {
 public:
  virtual ~LensMap() = default;
  virtual std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const = 0;
  virtual std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const = 0;
};

}  // namespace limn
