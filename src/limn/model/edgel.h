// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace limn {

// Index of an edgel in its EdgeMap. The same id serves linking, support lists and networks.
using EdgelId = int32_t;
constexpr EdgelId kInvalidEdgel = -1;

// A sub-pixel oriented edge point. Pixels: the center of the top-left pixel is (0, 0), x right, y
// down.
struct Edgel {
  // Position in the view's virtual pinhole image (the stored image itself when it has no
  // distortion).
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  // Direction of the edge in the virtual image, in [-pi, pi], such that luminance rises along (sin
  // t, -cos t), the left side on screen when walking along (cos t, sin t).
  double tangent_rad = 0;
  // Gradient magnitude at the edge, gray levels per pixel. For given edges, what their file says,
  // such as a probability; 1 for curves without edgels. Not below 0.
  float strength = 0;
  // Standard deviation of the position across the edge, stored pixels.
  float position_sigma_px = 0;
  // Position in the image as stored.
  Eigen::Vector2f stored_px = Eigen::Vector2f::Zero();
  // Jacobian d stored / d virtual at the edgel, for gates in stored pixels.
  Eigen::Matrix2f stored_from_virtual = Eigen::Matrix2f::Identity();

  Eigen::Vector2d Tangent() const { return {std::cos(tangent_rad), std::sin(tangent_rad)}; }
  // Unit normal along which luminance rises.
  Eigen::Vector2d Normal() const { return {std::sin(tangent_rad), -std::cos(tangent_rad)}; }
  // Reverses the tangent, so that the other side is the brighter one.
  void Turn() { tangent_rad = std::remainder(tangent_rad + M_PI, 2 * M_PI); }
};

}  // namespace limn
