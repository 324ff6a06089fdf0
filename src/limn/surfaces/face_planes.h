// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/surfaces/face_links.h"
#include "limn/util/parallel.h"

namespace limn {

// A plane with links that may bound faces in it: normal . x = offset.
struct FacePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  std::vector<int> members;  // indices of links, ascending
};

// Planes in which faces may lie (ours; algorithm/surfaces.md#planes). Each grows from a bent link
// that is flat, or from two links that meet or nearly meet, over all links that meet those it has
// and are within plane_tolerance_px of it, fitted again as it grows. Planes of fewer than three
// links remain only if a closed one is among them; the links of those that are all in one with more
// join it, wherever they are. The plane with most length before that comes first. Time: hypotheses
// times links of their planes, and squared number of planes.
std::vector<FacePlane> FindFacePlanes(const std::vector<FaceLink>& links, const DrawingGraph& graph,
                                      const SurfaceOptions& options, const RunContext& context);

}  // namespace limn
