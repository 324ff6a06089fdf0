// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "colmap_ext/model/camera_model.h"

namespace limn::colmap_ext {

// Projection and unprojection of every COLMAP camera model but EQUIRECTANGULAR, between a ray
// (u, v, 1) and a pixel in COLMAP's convention (corner of the image at (0, 0)).
//
// A model is used only where it can be inverted: up to the smallest angle from the optical axis at
// which the Jacobian of the distortion stops having a positive determinant in any direction
// (polynomial distortions fold beyond it), and at most 75 degrees. Immutable, safe to share between
// threads.
class CameraProjection {
 public:
  // Samples the domain: about 10^4 evaluations of the model.
  explicit CameraProjection(Intrinsics intrinsics);

  // Nothing outside the domain.
  std::optional<Eigen::Vector2d> PixelFromRay(const Eigen::Vector2d& ray) const;

  // Newton's method from a tabulated start. Nothing if the pixel is not in the image of the domain,
  // or if the iteration does not converge to 1e-12 of the focal length.
  std::optional<Eigen::Vector2d> RayFromPixel(const Eigen::Vector2d& pixel) const;

  // Largest |(u, v)| of the domain; 0 if the model is degenerate even on the axis.
  double MaxRadius() const { return max_radius_; }
  const Intrinsics& intrinsics() const { return intrinsics_; }

 private:
  Eigen::Vector2d StartFor(const Eigen::Vector2d& distorted) const;

  Intrinsics intrinsics_;
  double max_radius_ = 0;
  // Distorted radius at equal steps of the angle from the axis, along +u; increasing.
  std::vector<double> distorted_radius_;
};

}  // namespace limn::colmap_ext
