// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/triangle_parts.h"

#include <algorithm>
#include <map>
#include <utility>

namespace limn {
namespace {

// How many triangles have each edge, from its lower vertex to the other.
std::map<std::pair<int, int>, int> CountEdges(const DrawingFace& face) {
  std::map<std::pair<int, int>, int> counts;
  for (const auto& triangle : face.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      ++counts[std::minmax({triangle[corner], triangle[(corner + 1) % 3]})];
    }
  }
  return counts;
}

}  // namespace

std::vector<TrianglePart> PartsOf(const DrawingFace& face) {
  constexpr size_t kMaxTriangles = 10'000;
  const std::map<std::pair<int, int>, int> counts = CountEdges(face);
  std::vector<TrianglePart> parts;
  std::vector<int> new_vertex;
  for (size_t t = 0; t < face.triangles.size(); ++t) {
    if (t % kMaxTriangles == 0) {
      parts.emplace_back();
      new_vertex.assign(face.vertices.size(), -1);
    }
    TrianglePart& part = parts.back();
    std::array<int, 3> triangle = face.triangles[t];
    std::array<bool, 3> is_border = {};
    for (int corner = 0; corner < 3; ++corner) {
      const auto edge =
          std::minmax({face.triangles[t][corner], face.triangles[t][(corner + 1) % 3]});
      is_border[corner] = counts.at(edge) == 1;
      int& vertex = new_vertex[triangle[corner]];
      if (vertex < 0) {
        vertex = static_cast<int>(part.vertices.size());
        part.vertices.push_back(face.vertices[triangle[corner]]);
      }
      triangle[corner] = vertex;
    }
    part.triangles.push_back(triangle);
    part.is_border.push_back(is_border);
  }
  return parts;
}

}  // namespace limn
