// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/regularity/regularity_options.h"
#include "limn/regularity/shape_evidence.h"

namespace limn {

// Arcs and circles, indices of evidence, ascending.
struct RadiusClass {
  double radius = 1;  // local units
  std::vector<int> arcs;
};
struct AxisClass {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // local units
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  std::vector<int> arcs;
};

// Radii that arcs share (ours): arcs join if a common radius takes less information than one radius
// each, to their accuracy, and moves none by more than max_shift_px. Time n^2.
std::vector<RadiusClass> FindEqualRadii(const std::vector<ArcEvidence>& arcs,
                                        const RegularityOptions& options);

// Axes that arcs share: their centers are on a line along their normals. As for radii. Time n^2.
std::vector<AxisClass> FindCommonAxes(const std::vector<ArcEvidence>& arcs,
                                      const RegularityOptions& options);

}  // namespace limn
