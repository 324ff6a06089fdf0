#pragma once

#include <vector>

#include <Eigen/Core>

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

}  // namespace limn
