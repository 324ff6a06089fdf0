#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// Which views may contain a place: asked once for a curve, so that its points are projected into
// those views only and not into all.
class ViewFinder {
 public:
  explicit ViewFinder(const std::vector<View>& views);

  // Ascending: every view whose image contains a point within `radius` of `center`, and those that
  // come near it. Time: views, a few comparisons each.
  std::vector<ViewId> Near(const Eigen::Vector3d& center, double radius) const;

  // The same for the points of a curve; empty if there is none.
  std::vector<ViewId> NearAnyOf(const std::vector<Eigen::Vector3d>& points) const;

 private:
  // Four sides of the frustum and the plane through the camera's center: the distance inwards of a
  // point is normal * (x, y, z, 1).
  using Planes = Eigen::Matrix<double, 5, 4>;

  std::vector<Planes> planes_;
};

}  // namespace limn
