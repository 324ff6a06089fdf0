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

// The views that a view of a large scene may be matched with, found without looking at all of them.
class NeighborFinder {
 public:
  // A scene of no more views is one neighborhood.
  static constexpr int kSmallScene = 256;
  // A view has no more neighbors in a larger one.
  static constexpr int kMaxNeighbors = 160;

  // Angles at a point between two views that see it, degrees, that let them be matched. The views
  // must outlive this.
  NeighborFinder(const std::vector<View>& views, double min_angle_deg, double max_angle_deg);

  // Ascending. Candidates are the views that see some place of the view's image at a depth of the
  // span under a usable angle, from at most three times as far: none of these is farther away than
  // three times the far depth. They are thinned evenly in every octave of distance, since depths
  // of an octave are told apart by cameras of a few octaves of distance. Without a span, the one
  // that the distances to the nearest cameras suggest. Time: cameras within reach, a comparison
  // each, and some thousand projections.
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

// Angle between two vectors, degrees.
double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// Where the pixels of a coarse grid that the photograph covers lie at these depths, in the world:
// pixel by pixel.
std::vector<Eigen::Vector3d> PlacesInFront(const View& view, const std::vector<double>& depths);

// Twice the median distance of the points from their mean. Precondition: there is one.
double Extent(const std::vector<Eigen::Vector3d>& points);

}  // namespace limn
