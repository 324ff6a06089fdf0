#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace limn {

// A surface of polygons. Vertices have positions of their own: no two are at the same place.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  // Per polygon its corners in order, at least three vertex indices. Orientations may differ.
  std::vector<std::vector<int>> polygons;
  // All polygons cut into triangles.
  std::vector<std::array<int, 3>> triangles;
  // Polygons that were left out: without area, and copies (same corners) of others.
  int num_degenerate = 0;
  int num_copies = 0;
};

// A mesh from polygons over vertices in any number of copies: vertices at exactly the same position
// become one, corners that repeat the one before vanish. Precondition: indices are in range and
// coordinates finite. O(n log n) but for large polygons, see TriangulatePolygon.
TriangleMesh MakeTriangleMesh(const std::vector<Eigen::Vector3d>& vertices,
                              const std::vector<std::vector<int>>& polygons);

// The corners' positions.
std::vector<Eigen::Vector3d> CornersOf(const TriangleMesh& mesh, const std::vector<int>& polygon);

}  // namespace limn
