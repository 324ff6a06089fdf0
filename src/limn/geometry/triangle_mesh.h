// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace limn {

// A surface of polygons. No two vertices have the same position.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  // Per polygon its corners in order, at least three vertex indices. Orientations may differ.
  std::vector<std::vector<int>> polygons;
  // The triangulation of all polygons.
  std::vector<std::array<int, 3>> triangles;
  // Polygons that were dropped: those without area, and copies (same corners) of others.
  int num_degenerate = 0;
  int num_copies = 0;
};

// Makes a mesh from polygons whose vertices may have copies: vertices at exactly the same position
// are merged, and consecutive equal corners are too. Precondition: indices in range, coordinates
// finite. O(n log n) except for large polygons, see TriangulatePolygon.
TriangleMesh MakeTriangleMesh(const std::vector<Eigen::Vector3d>& vertices,
                              const std::vector<std::vector<int>>& polygons);

// The corners' positions.
std::vector<Eigen::Vector3d> CornersOf(const TriangleMesh& mesh, const std::vector<int>& polygon);

}  // namespace limn
