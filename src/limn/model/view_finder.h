// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// Finds the views that may contain a place. One query per curve saves projecting its points into
// all views.
class ViewFinder {
 public:
  explicit ViewFinder(const std::vector<View>& views);

  // Every view whose image contains a point within `radius` of `center`, and a few that come close;
  // ascending. Linear in the number of views, a few comparisons each.
  std::vector<ViewId> Near(const Eigen::Vector3d& center, double radius) const;

  // The same for the points of a curve; empty if it has none.
  std::vector<ViewId> NearAnyOf(const std::vector<Eigen::Vector3d>& points) const;

 private:
  // Four sides of the frustum and the plane through the camera's center, as rows: row * (x, y, z,
  // 1) is the inward distance of a point.
  using Planes = Eigen::Matrix<double, 5, 4>;

  std::vector<Planes> planes_;
};

}  // namespace limn
