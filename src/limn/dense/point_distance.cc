#include "limn/dense/point_distance.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/spatial_index.h"

namespace limn {

std::vector<uint8_t> FindSamplesNearPoints(const DrawingSamples& samples,
                                           const DensePointStream& points, double near_px) {
  std::vector<uint8_t> near(samples.size(), 0);
  if (samples.size() == 0) return near;
  const double reach =
      near_px * *std::max_element(samples.footprint.begin(), samples.footprint.end());
  const SpatialIndex index(samples.position);
  std::vector<SpatialIndex::Neighbor> found;
  points([&](const DensePoint& point) {
    index.FindWithin(point.position, reach, &found);
    for (const SpatialIndex::Neighbor& neighbor : found) {
      const double radius = near_px * samples.footprint[neighbor.index];
      near[neighbor.index] |= neighbor.squared_distance <= radius * radius;
    }
  });
  return near;
}

}  // namespace limn
