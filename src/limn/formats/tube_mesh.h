// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"

namespace limn {

// The surface of a rod as triangles, counterclockwise as seen from outside.
struct TubeMesh {
  std::vector<Eigen::Vector3d> vertices;
  // Unit vectors, one per vertex: smooth around and along the tube, sharp at its ends.
  std::vector<Eigen::Vector3d> normals;
  std::vector<std::array<int, 3>> triangles;
};

// A tube of twelve sides around a polyline of some length, with flat ends; a closed one, whose
// polyline returns to its first point, has none. Cross-sections do not turn about the polyline,
// except that in a closed tube what is missing for the last to meet the first is spread over its
// length. `radius` > 0 is that of the corners. Linear time.
TubeMesh MakeTube(const Polyline3d& points, bool closed, double radius);

}  // namespace limn
