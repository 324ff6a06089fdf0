// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/triangle_mesh.h"
#include "limn/model/faces.h"

namespace limn {

// Adds triangles to those that a mesh has. For depth images: vertices at the same position are not
// merged, and there are no polygons.
void AddTriangles(const std::vector<Eigen::Vector3d>& vertices,
                  const std::vector<std::array<int, 3>>& triangles, TriangleMesh* mesh);

// The triangles of all faces, in order. Linear time.
TriangleMesh MeshOf(const std::vector<DrawingFace>& faces);

}  // namespace limn
