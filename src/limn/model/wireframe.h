// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/util/length_unit.h"

namespace limn {

// Corners, and straight edges between them.
struct Wireframe {
  std::vector<Eigen::Vector3d> vertices;
  // Indices of two vertices each.
  std::vector<std::pair<int, int>> edges;
  // Of the coordinates; kNone: unknown.
  LengthUnit unit = LengthUnit::kNone;
};

}  // namespace limn
