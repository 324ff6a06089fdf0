// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Copies with `shift` added to all positions. Files store the coordinates of the model; the stages
// work relative to Project::origin().
DrawingGraph Moved(DrawingGraph graph, const Eigen::Vector3d& shift);
CurveSketch Moved(CurveSketch sketch, const Eigen::Vector3d& shift);
std::vector<View> Moved(std::vector<View> views, const Eigen::Vector3d& shift);
std::optional<Eigen::AlignedBox3d> Moved(std::optional<Eigen::AlignedBox3d> box,
                                         const Eigen::Vector3d& shift);

}  // namespace limn::colmap_ext
