// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "limn/geometry/polygon2d.h"

namespace limn {

// Splits edges longer than `max_length` > 0 at their middles, in both triangles, longest first, up
// to `max_vertices` vertices. Triangles keep their orientation. Time: splits times edges.
void RefineTriangles(double max_length, size_t max_vertices, Polyline2d* vertices,
                     std::vector<std::array<int, 3>>* triangles);

}  // namespace limn
