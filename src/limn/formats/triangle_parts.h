// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/model/faces.h"

namespace limn {

// Some triangles of a face with the vertices that they use.
struct TrianglePart {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  // Per triangle and corner: whether no other triangle of the face has the edge from this corner
  // to the next.
  std::vector<std::array<bool, 3>> is_border;
};

// The triangles of a face in parts of at most 10,000, as formats with short indices need them. In
// order; none if there are no triangles. Time n log n.
std::vector<TrianglePart> PartsOf(const DrawingFace& face);

}  // namespace limn
