// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "limn/model/drawing_graph.h"

namespace limn {

// Removes everything outside the core of a tile. Links that leave it are cut and end exactly on its
// border. Linear in the number of points.
void CropDrawing(const Eigen::AlignedBox3d& core, DrawingGraph* graph);

// Removes everything inside a box, the opposite of CropDrawing.
void CutOut(const Eigen::AlignedBox3d& hole, DrawingGraph* graph);

// Returns whether a point made by CropDrawing or CutOut lies exactly on the border.
bool IsOnBorder(const Eigen::AlignedBox3d& core, const Eigen::Vector3d& point);

}  // namespace limn
