// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/geometry/spatial_index.h"
#include "limn/model/view.h"

namespace limn {

// Depths (z in a camera), 0 < near <= far.
struct DepthSpan {
  double near = 0;
  double far = 0;
};

// Finds the views with which a view of a large scene may be matched, without looking at all of
// them.
class NeighborFinder {
 public:
  // A scene of this many views or fewer is one neighborhood.
  static constexpr int kSmallScene = 256;
  // Largest number of neighbors of a view in a larger scene.
  static constexpr int kMaxNeighbors = 160;

  // Two views can be matched if the angle between them, at a point that both see, is within these
  // limits, degrees. The views must outlive this.
  NeighborFinder(const std::vector<View>& views, double min_angle_deg, double max_angle_deg);

  // Returns neighbors in ascending order. Candidates are the views that see some place in the
  // view's image, at a depth within the span, under a usable angle and from at most three times the
  // far depth. They are thinned evenly in every octave of distance, since depths of one octave are
  // resolved by cameras within a few octaves of distance. Without a span, one is estimated from the
  // distances to the nearest cameras. Time: one comparison per camera within reach, and some
  // thousand projections.
  std::vector<ViewId> Find(ViewId view, const std::optional<DepthSpan>& depths) const;

 private:
  DepthSpan SpanOfCameras(ViewId view) const;
  bool SeesAny(ViewId other, ViewId view, const std::vector<Eigen::Vector3d>& places) const;

  const std::vector<View>& views_;
  std::vector<Eigen::Vector3d> centers_;
  double min_angle_deg_;
  double max_angle_deg_;
  SpatialIndex index_;
};

// World positions, at these depths, of the pixels of a coarse grid over the photograph, pixel by
// pixel.
std::vector<Eigen::Vector3d> PlacesInFront(const View& view, const std::vector<double>& depths);

// Twice the median distance of the points from their mean. Precondition: there is one.
double Extent(const std::vector<Eigen::Vector3d>& points);

}  // namespace limn
