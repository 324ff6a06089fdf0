// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "limn/geometry/pinhole_camera.h"
#include "limn/model/lens_map.h"

namespace limn {

class Calibration;

// The optics of a camera at one size of its images.
struct Optics {
  PinholeCamera camera;
  // Null if the stored image is a pinhole image.
  std::shared_ptr<const LensMap> lens;
  std::shared_ptr<const Calibration> calibration;
};

// The optics of a camera as a function of the parameters of its model: focal lengths, principal
// point, distortion. Immutable.
class Calibration {
 public:
  virtual ~Calibration() = default;
  virtual Eigen::VectorXd Parameters() const = 0;
  // How a stored pixel moves when a parameter changes and the ray stays, px per unit of the
  // parameter: a column each. Nothing where the lens cannot map.
  virtual std::optional<Eigen::Matrix2Xd> StoredByParameters(
      const Eigen::Vector2d& virtual_px) const = 0;
  virtual Optics WithParameters(const Eigen::VectorXd& parameters) const = 0;
};

}  // namespace limn
