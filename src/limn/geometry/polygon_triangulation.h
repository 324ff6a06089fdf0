#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace limn {

// Twice the area of a polygon in space times its unit normal (Newell): the corners go round it
// counter-clockwise. Exact for planar polygons, a mean plane for others.
Eigen::Vector3d PolygonAreaVector(std::span<const Eigen::Vector3d> corners);

// Cuts a simple polygon in space, convex or not, into triangles of its corners (indices), by
// clipping ears in the coordinate plane that it faces most. Triangles keep its orientation; those
// of no area are left out. A polygon that crosses itself gives some triangles of its corners.
// O(n^2).
std::vector<std::array<int, 3>> TriangulatePolygon(std::span<const Eigen::Vector3d> corners);

}  // namespace limn
