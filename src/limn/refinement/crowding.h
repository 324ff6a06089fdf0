// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/support/edgel_index.h"

namespace limn {

// A place of a link in the image of a view.
struct ImagePlace {
  int link = -1;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // unit, undirected
};

// Finds where reprojected links run side by side in one view, so near that the image may show one
// blurred edge instead of two. Immutable.
class Crowding {
 public:
  explicit Crowding(std::vector<ImagePlace> places);

  // Returns whether another link passes within the distance, in nearly the same direction, with a
  // place up to half a step ahead or behind.
  bool At(const ImagePlace& place, double distance_px, double half_step_px) const;

 private:
  std::vector<ImagePlace> places_;
  EdgelIndex index_;  // holds the places as edgels
};

}  // namespace limn
