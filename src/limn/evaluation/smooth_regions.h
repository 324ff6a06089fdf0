// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/geometry/triangle_mesh.h"

namespace limn {

// The region of each triangle, numbered from 0 in the order of their first triangles: neighbors
// are of one region where just these two meet and the surface bends by less than `max_bend_deg`
// between them. A flat side of a solid is one region, so is a finely meshed cylinder. O(n log n).
std::vector<int> SmoothRegions(const TriangleMesh& mesh, double max_bend_deg);

}  // namespace limn
