// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/parallel_samples.h"

#include <cmath>

#include "limn/geometry/polyline.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

const double kMinParallelCosine = std::cos(20 * kDeg);

}  // namespace

void FindParallel(const CurveSamples& samples, const Eigen::Vector3d& place,
                  const Eigen::Vector3d& direction, double radius,
                  std::vector<SpatialIndex::Neighbor>* found) {
  samples.FindNear(place, radius, found);
  size_t num_kept = 0;
  for (const SpatialIndex::Neighbor& near : *found) {
    const double cosine = std::abs(direction.dot(samples.Direction(near.index)));
    if (!(cosine >= kMinParallelCosine)) continue;
    const double squared = ClosestPoint(samples.Cell(near.index), place).squared_distance;
    if (squared <= radius * radius) (*found)[num_kept++] = {near.index, squared};
  }
  found->resize(num_kept);
}

}  // namespace limn
