// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace limn {

// Angles are in radians, but in degrees in options and in texts: 15 * kDeg are 15 degrees.
inline constexpr double kDeg = M_PI / 180;

inline double Degrees(double angle_rad) { return angle_rad * 180 / M_PI; }

// How far apart two directions in a plane are, in [0, pi], each given as its angle from a common
// axis.
inline double TurnBetweenAngles(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2 * M_PI));
}

}  // namespace limn
