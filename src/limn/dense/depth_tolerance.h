// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Difference in depth, px footprints, up to which a surface is at the depth of a curve that is this
// far from it in the image: what is allowed there, and what a surface at 60 degrees gains.
inline double DepthTolerancePx(double allowed_px, double distance_px) {
  constexpr double kMaxSlope = 1.7;  // tangent of the angle to the image plane
  return allowed_px + kMaxSlope * distance_px;
}

}  // namespace limn
