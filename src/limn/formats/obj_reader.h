// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_set.h"
#include "limn/model/wireframe.h"

namespace limn {

// Reads the v, l and p statements of a Wavefront OBJ file; others are ignored. Line elements of one
// object or group (o, g) are joined by ChainEdges. If there is any l or p, unused vertices are
// dropped; else all vertices are points. Throws IoError.
CurveSet ReadObjCurves(const std::string& path);

// The v and l statements as they are; nothing if there is no line (unless there may be none), one
// of more than two vertices, a point or a face. Other statements are ignored. Throws IoError.
std::optional<Wireframe> ReadObjWireframe(const std::string& path, bool may_lack_edges = false);

// The v and f statements: vertices, and per face the indices of its corners, at least three.
struct FaceSoup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;
};

// Other statements are ignored. Throws IoError.
FaceSoup ReadObjFaces(const std::string& path);

}  // namespace limn
