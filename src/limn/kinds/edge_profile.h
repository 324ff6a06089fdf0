// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limn/model/image.h"

namespace limn {

// Red, green and blue, gray levels. Of an image of one channel all three are the same.
using SideColor = std::array<float, 3>;

// The step of an image across an edge at one place.
struct EdgeProfile {
  // Standard deviation of the blur of the step, px: contrast / (largest slope * sqrt(2 pi)).
  float width_px = 0;
  float contrast = 0;  // of the luminance, gray levels
  // Colors where the step ends, on the sides of (sin t, -cos t) and of (-sin t, cos t).
  SideColor left = {};
  SideColor right = {};
};

// Measures the step across a curve at a place of the stored image, where its direction is
// (cos t, sin t): the mean profile of 7 px along the curve, to 7 px on either side
// (algorithm/kinds.md#profiles). Nothing if the image does not contain all of it, if it is masked,
// or if there is no step of 2 gray levels within 1 px of the curve.
std::optional<EdgeProfile> MeasureProfile(const Image& image, const Eigen::Vector2d& place_px,
                                          const Eigen::Vector2d& along);

}  // namespace limn
