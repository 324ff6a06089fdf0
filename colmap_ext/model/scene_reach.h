// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// How far from the middle of a scene its cameras and points may be. Anything 100,000 times as far
// away as most others is a mistake that would spoil every measure of the scene.
class SceneReach {
 public:
  // From the medians of these images of the model and of its points: fewer than half of either may
  // be wrong. Linear time.
  SceneReach(const SparseModel& model, const std::vector<int>& images);

  bool Contains(const Eigen::Vector3d& place) const;

 private:
  Eigen::Vector3d middle_;
  double radius_;  // 0 if nothing is known
};

}  // namespace limn::colmap_ext
