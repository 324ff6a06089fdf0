// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "support/synthetic_scene.h"

namespace limn::testing {

// Points of the plane that all views look down on, px.
using PxLine = std::vector<Eigen::Vector2d>;

inline Polyline3d InWorld(const PxLine& line) {
  Polyline3d points;
  for (const Eigen::Vector2d& point : line) points.push_back(FrontalPoint(point.x(), point.y()));
  return points;
}

inline Eigen::Vector2d Unit(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

// The line from a point in a direction.
inline PxLine Ray(const Eigen::Vector2d& from, double angle_rad, double length_px) {
  return {from, from + length_px * Unit(angle_rad)};
}

// An arc from the origin, which it leaves along the x axis, turning left.
inline PxLine ArcFromOrigin(double radius_px, double turn_rad) {
  PxLine arc;
  const int count = static_cast<int>(std::ceil(4 * radius_px * turn_rad));
  for (int k = 0; k <= count; ++k) {
    const double angle = turn_rad * k / count;
    arc.emplace_back(radius_px * std::sin(angle), radius_px * (1 - std::cos(angle)));
  }
  return arc;
}

// The whole circle.
inline PxLine RingThroughOrigin(double radius_px) {
  PxLine ring = ArcFromOrigin(radius_px, 2 * M_PI);
  ring.back() = ring.front();
  return ring;
}

}  // namespace limn::testing
