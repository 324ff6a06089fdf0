// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/faces.h"

namespace limn {

// A unit vector per vertex of a face: the mean normal of the triangles there, weighted by their
// areas; that of all triangles where these have none, and the z axis if no triangle has an area.
// All vertices of a plane have its normal. Linear time.
std::vector<Eigen::Vector3d> VertexNormals(const DrawingFace& face);

}  // namespace limn
