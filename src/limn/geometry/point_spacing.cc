#include "limn/geometry/point_spacing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/geometry/spatial_index.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// The nearest point that is not at the same place, in balls that grow up to `largest`; 0 if none.
double NearestOther(const SpatialIndex& index, const Eigen::Vector3d& point, double radius,
                    double largest) {
  std::vector<SpatialIndex::Neighbor> found;
  for (; radius <= 2 * largest; radius *= 2) {
    index.FindWithin(point, radius, &found);
    double nearest = 0;
    for (const SpatialIndex::Neighbor& other : found) {
      const double squared = other.squared_distance;
      if (squared > 0 && (nearest == 0 || squared < nearest)) nearest = squared;
    }
    if (nearest > 0) return std::sqrt(nearest);
  }
  return 0;
}

}  // namespace

double PointSpacing(const std::vector<Eigen::Vector3d>& points) {
  constexpr size_t kMaxAsked = 1000;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  if (points.empty() || !(box.diagonal().norm() > 0)) return 0;
  const double largest = box.diagonal().norm();
  const double first = largest / static_cast<double>(points.size());
  const SpatialIndex index(points);
  std::vector<double> distances;
  const size_t count = std::min(kMaxAsked, points.size());
  for (size_t k = 0; k < count; ++k) {
    const double distance = NearestOther(index, points[k * points.size() / count], first, largest);
    if (distance > 0) distances.push_back(distance);
  }
  return Median(std::move(distances));
}

}  // namespace limn
