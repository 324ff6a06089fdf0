#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// A triangulated point of the sparse model and the views that see it.
struct ScenePoint {
  Eigen::Vector3d position_in_world;
  std::vector<ViewId> views;  // ascending
};

// What structure from motion knows of the scene beyond the poses. May be empty: a bonus, never
// needed.
struct SceneHints {
  std::vector<ScenePoint> points;
};

}  // namespace limn
