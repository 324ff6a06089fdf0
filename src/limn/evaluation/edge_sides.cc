// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/edge_sides.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/Geometry>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/polygon_triangulation.h"

namespace limn {
namespace {

std::vector<EdgeSide> SidesByEdge(const std::vector<Eigen::Vector3d>& vertices,
                                  const std::vector<std::vector<int>>& polygons) {
  std::vector<EdgeSide> sides;
  for (size_t p = 0; p < polygons.size(); ++p) {
    const std::vector<int>& polygon = polygons[p];
    std::vector<Eigen::Vector3d> corners;
    for (const int vertex : polygon) corners.push_back(vertices[vertex]);
    const Eigen::Vector3d normal = PolygonAreaVector(corners).normalized();
    for (size_t k = 0; k < polygon.size(); ++k) {
      const int from = polygon[k];
      const int to = polygon[(k + 1) % polygon.size()];
      const Eigen::Vector3d along = vertices[to] - vertices[from];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(p),
                       normal.cross(along.normalized()).normalized()});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const EdgeSide& s, const EdgeSide& t) {
    return std::tie(s.a, s.b) < std::tie(t.a, t.b);
  });
  return sides;
}

}  // namespace

void ForEachEdge(const std::vector<Eigen::Vector3d>& vertices,
                 const std::vector<std::vector<int>>& polygons,
                 const std::function<void(std::span<const EdgeSide>)>& visit) {
  const std::vector<EdgeSide> sides = SidesByEdge(vertices, polygons);
  for (size_t begin = 0; begin < sides.size();) {
    size_t end = begin + 1;
    while (end < sides.size() && sides[end].a == sides[begin].a && sides[end].b == sides[begin].b) {
      ++end;
    }
    visit({sides.data() + begin, end - begin});
    begin = end;
  }
}

double BendAt(const EdgeSide& side, const EdgeSide& other) {
  return M_PI - AngleBetween(side.inwards, other.inwards);
}

}  // namespace limn
