// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/polyline.h"

namespace limn {

// A wire, cable, bar or rod: a round body around an axis.
struct Rod {
  // Two points at least, about 6 px apart.
  std::vector<Eigen::Vector3d> axis;
  double radius = 0;     // world units
  double footprint = 0;  // world units per px
};

// Whether a place is within the outlines of a rod, or this far outside.
inline bool IsBeside(const Rod& rod, const Eigen::Vector3d& place, double outside_px) {
  const double reach = rod.radius + outside_px * rod.footprint;
  return ClosestPoint(rod.axis, place).squared_distance < reach * reach;
}

// Whether a curve that passes a place there in this direction, of either sign, runs along a rod.
inline bool RunsAlong(const Rod& rod, const Eigen::Vector3d& place,
                      const Eigen::Vector3d& direction, double outside_px, double max_turn_rad) {
  if (!IsBeside(rod, place, outside_px)) return false;
  const int segment = ClosestPoint(rod.axis, place).segment;
  return LineAngleBetween(rod.axis[segment + 1] - rod.axis[segment], direction) < max_turn_rad;
}

}  // namespace limn
