// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A place on a link and its metric for deviations.
struct LinkSample3d {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  // Position along the link, 0 to 1 by length.
  double t = 0;
  // |across * d|^2 is the mean over the views of the squared distance, px^2, by which a small
  // offset d moves the point across the projected curve. Offsets along the curve count little.
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  // Unit vector along the curve.
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  // 1, or less near ends at nodes, where the edges of several curves run into one another.
  double weight = 1;
};

struct LinkSamples {
  std::vector<LinkSample3d> samples;  // at least five, first and last point included
  double length_px = 0;               // length / footprint
  double footprint = 0;               // world units, at the middle of the link
};

// Samples a link about every 2 px, as seen in its supporting views (in all that show the place if
// it has none). Empty if no view sees it. Time: samples times views.
LinkSamples SampleLink(const DrawingLink& link, const std::vector<View>& views);

// Reduces the weight of samples within `zone_px` (at most a quarter of the length) of these ends.
void DiscountEnds(const std::array<bool, 2>& ends, double zone_px, LinkSamples* link);

}  // namespace limn
