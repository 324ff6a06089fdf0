// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace limn {

// Twice the area of a polygon in space times its unit normal (Newell), around which the corners are
// counterclockwise. Exact for planar polygons, a mean plane for others.
Eigen::Vector3d PolygonAreaVector(std::span<const Eigen::Vector3d> corners);

// Triangulates a simple polygon in space, convex or not, by ear clipping in the coordinate plane
// that it faces most. Returns corner indices. Triangles keep the orientation; those without area
// are dropped. For a self-intersecting polygon the triangles are arbitrary. O(n^2).
std::vector<std::array<int, 3>> TriangulatePolygon(std::span<const Eigen::Vector3d> corners);

}  // namespace limn
