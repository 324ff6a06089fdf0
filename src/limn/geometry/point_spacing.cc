// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/point_spacing.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "limn/geometry/spatial_index.h"
#include "limn/util/median.h"

namespace limn {
namespace {

std::vector<Eigen::Vector3d> WithoutCopies(std::vector<Eigen::Vector3d> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

double PointSpacing(const std::vector<Eigen::Vector3d>& points) {
  constexpr size_t kMaxAsked = 1000;
  const std::vector<Eigen::Vector3d> places = WithoutCopies(points);
  if (places.size() < 2) return 0;
  const SpatialIndex index(places);
  std::vector<double> distances;
  std::vector<SpatialIndex::Neighbor> nearest;
  const size_t count = std::min(kMaxAsked, points.size());
  for (size_t k = 0; k < count; ++k) {
    // The point itself, then the next.
    index.FindNearest(points[k * points.size() / count], 2, &nearest);
    if (nearest[1].squared_distance > 0) {
      distances.push_back(std::sqrt(nearest[1].squared_distance));
    }
  }
  return Median(std::move(distances));
}

}  // namespace limn
