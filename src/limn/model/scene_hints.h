// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// Where a view sees a point, virtual px.
struct PointPixel {
  ViewId view = -1;
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  // Jacobian d stored / d virtual there.
  Eigen::Matrix2d stored_from_virtual = Eigen::Matrix2d::Identity();
};

// A triangulated point of the sparse model and the views that see it.
struct ScenePoint {
  Eigen::Vector3d position_in_world;
  std::vector<ViewId> views;  // ascending
  // Where views see it, if known; ascending by view.
  std::vector<PointPixel> pixels = {};
  // Order of the point in the COLMAP model file.
  int model_index = -1;
};

// What structure from motion found in addition to the poses. May be empty: no stage requires it.
struct SceneHints {
  std::vector<ScenePoint> points;
};

}  // namespace limn
