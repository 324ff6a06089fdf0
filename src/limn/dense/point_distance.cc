// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/point_distance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/geometry/spatial_index.h"

namespace limn {
namespace {

// Samples of alike footprints: one radius serves them all.
struct Level {
  std::vector<int> samples;
  std::vector<Eigen::Vector3d> positions;
  double largest_footprint = 0;
};

}  // namespace

std::vector<uint8_t> FindSamplesNearPoints(const DrawingSamples& samples,
                                           const DensePointStream& points, double near_px) {
  std::map<int, Level> levels;
  for (size_t s = 0; s < samples.size(); ++s) {
    Level& level = levels[static_cast<int>(std::floor(std::log2(samples.footprint[s])))];
    level.samples.push_back(static_cast<int>(s));
    level.positions.push_back(samples.position[s]);
    level.largest_footprint = std::max(level.largest_footprint, samples.footprint[s]);
  }
  std::map<int, SpatialIndex> indexes;
  for (const auto& [id, level] : levels) indexes.emplace(id, SpatialIndex(level.positions));
  std::vector<uint8_t> near(samples.size(), 0);
  std::vector<SpatialIndex::Neighbor> found;
  points([&](const DensePoint& point) {
    for (const auto& [id, level] : levels) {
      indexes.at(id).FindWithin(point.position, near_px * level.largest_footprint, &found);
      for (const SpatialIndex::Neighbor& neighbor : found) {
        const int sample = level.samples[neighbor.index];
        const double radius = near_px * samples.footprint[sample];
        near[sample] |= neighbor.squared_distance <= radius * radius;
      }
    }
  });
  return near;
}

}  // namespace limn
