#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_set.h"

namespace limn {

// Reads the v, l and p statements of a Wavefront OBJ file; others are ignored. Line elements of one
// object or group (o, g) are joined by ChainEdges. If there is any l or p, unused vertices are
// dropped; else all vertices are points. Throws IoError.
CurveSet ReadObjCurves(const std::string& path);

// The v and f statements: vertices, and per face the indices of its corners, at least three.
struct FaceSoup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;
};

// Other statements are ignored. Throws IoError.
FaceSoup ReadObjFaces(const std::string& path);

}  // namespace limn
