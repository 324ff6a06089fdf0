// SPDX-License-Identifier: BSD-3-Clause
#include "support/meshes.h"

namespace limn::testing {

TriangleMesh CubeMesh(const Eigen::Vector3d& center, double half_side, unsigned leave_out) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
  for (int face = 0; face < 6; ++face) {
    if (leave_out >> face & 1) continue;
    const int axis = face / 2;
    const int first = static_cast<int>(vertices.size());
    for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      Eigen::Vector3d corner;
      corner[axis] = face % 2 ? 1 : -1;
      corner[(axis + 1) % 3] = u;
      corner[(axis + 2) % 3] = v;
      vertices.push_back(center + half_side * corner);
    }
    polygons.push_back({first, first + 1, first + 2, first + 3});
  }
  return MakeTriangleMesh(vertices, polygons);
}

}  // namespace limn::testing
