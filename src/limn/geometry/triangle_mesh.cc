// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangle_mesh.h"

#include <algorithm>
#include <set>

#include "limn/geometry/polygon_triangulation.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/weld.h"

namespace limn {
namespace {

// Per vertex its index among the different positions, which go to `unique`.
std::vector<int> UniqueVertices(const std::vector<Eigen::Vector3d>& vertices,
                                std::vector<Eigen::Vector3d>* unique) {
  std::vector<int> index = WeldPoints(vertices);
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (index[i] < static_cast<int>(i)) {
      index[i] = index[index[i]];
    } else {
      index[i] = static_cast<int>(unique->size());
      unique->push_back(vertices[i]);
    }
  }
  return index;
}

std::vector<int> WithoutRepetitions(const std::vector<int>& polygon,
                                    const std::vector<int>& index) {
  std::vector<int> corners;
  for (const int vertex : polygon) {
    if (corners.empty() || corners.back() != index[vertex]) corners.push_back(index[vertex]);
  }
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

bool HasArea(const std::vector<Eigen::Vector3d>& corners) {
  // Rounding of the cross products is far below, the thinnest sliver of a CAD program far above.
  constexpr double kLeastShare = 1e-13;
  if (corners.size() < 3) return false;
  const double length = Length(corners);
  return PolygonAreaVector(corners).norm() > kLeastShare * length * length;
}

}  // namespace

std::vector<Eigen::Vector3d> CornersOf(const TriangleMesh& mesh, const std::vector<int>& polygon) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(polygon.size());
  for (const int vertex : polygon) corners.push_back(mesh.vertices[vertex]);
  return corners;
}

TriangleMesh MakeTriangleMesh(const std::vector<Eigen::Vector3d>& vertices,
                              const std::vector<std::vector<int>>& polygons) {
  TriangleMesh mesh;
  const std::vector<int> index = UniqueVertices(vertices, &mesh.vertices);
  std::set<std::vector<int>> seen;
  for (const std::vector<int>& polygon : polygons) {
    std::vector<int> corners = WithoutRepetitions(polygon, index);
    const std::vector<Eigen::Vector3d> positions = CornersOf(mesh, corners);
    if (!HasArea(positions)) {
      ++mesh.num_degenerate;
      continue;
    }
    std::vector<int> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(std::move(sorted)).second) {
      ++mesh.num_copies;
      continue;
    }
    for (const auto& [a, b, c] : TriangulatePolygon(positions)) {
      mesh.triangles.push_back({corners[a], corners[b], corners[c]});
    }
    mesh.polygons.push_back(std::move(corners));
  }
  return mesh;
}

}  // namespace limn
