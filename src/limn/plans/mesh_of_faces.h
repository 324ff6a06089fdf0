#pragma once

#include <vector>

#include "limn/geometry/triangle_mesh.h"
#include "limn/model/faces.h"

namespace limn {

// The triangles of all faces, for depth images: vertices where faces meet are not merged, and there
// are no polygons. Linear time.
TriangleMesh MeshOfFaces(const std::vector<DrawingFace>& faces);

}  // namespace limn
