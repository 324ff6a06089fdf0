// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace limn {

// A polygon of a surface at its edge a < b.
struct EdgeSide {
  int a = 0;
  int b = 0;
  int polygon = 0;
  // Unit vector in the polygon, across the edge, towards the polygon's inside; zero if it has no
  // area.
  Eigen::Vector3d inwards = Eigen::Vector3d::Zero();
};

// Calls visit with the sides of all polygons at one edge, for every edge, ascending by (a, b).
// O(n log n).
void ForEachEdge(const std::vector<Eigen::Vector3d>& vertices,
                 const std::vector<std::vector<int>>& polygons,
                 const std::function<void(std::span<const EdgeSide>)>& visit);

// By how much the surface bends from one polygon to the other at their edge, radians: 0 if it is
// flat, pi if it turns back. Orientations of polygons do not matter.
double BendAt(const EdgeSide& side, const EdgeSide& other);

}  // namespace limn
