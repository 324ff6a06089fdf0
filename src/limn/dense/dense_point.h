// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// A point of a dense cloud.
struct DensePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit; zero = unknown
  std::array<uint8_t, 3> color = {};
  double quality = 0;  // photometric score of PMVS; 0 = unknown
  // Views of the run that see it.
  std::vector<ViewId> views;
  bool views_known = false;
};

using DensePointVisitor = std::function<void(const DensePoint&)>;
// Calls the visitor with every point of a cloud, in the order of the cloud; may be called again.
// The cloud may be larger than memory.
using DensePointStream = std::function<void(const DensePointVisitor&)>;

}  // namespace limn
