// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/geometry/triangle_mesh.h"

namespace limn {

// Reads a surface from a file, by its extension: .ply (elements vertex and face, whose list is
// vertex_indices or vertex_index; ascii or binary of either byte order) or .obj (v and f
// statements). Faces are polygons of any number of corners; vertices at the same place are welded
// (MakeTriangleMesh). Throws IoError, also if there are no faces or none has an area.
TriangleMesh ReadMesh(const std::string& path);

}  // namespace limn
