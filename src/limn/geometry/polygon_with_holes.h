// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "limn/geometry/polygon2d.h"

namespace limn {

// Cuts a polygon with holes into triangles, counterclockwise if its border is. Corners are numbered
// through all outlines in order. Holes are joined to the border by cuts, then see
// TriangulatePolygon. Where outlines cross each other the triangles are arbitrary. O(n^2), times
// the number of holes.
std::vector<std::array<int, 3>> Triangulate(const Polygon2d& polygon);

}  // namespace limn
