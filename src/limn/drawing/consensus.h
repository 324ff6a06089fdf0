// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/drawing/samples.h"
#include "limn/util/parallel.h"

namespace limn {

// The length of an offset across a curve as the images see it, px: directions that they determine
// less well count less (algorithm/drawing.md#consensus).
class ReprojectedMetric {
 public:
  explicit ReprojectedMetric(const SampleArrays& samples);

  // Of an offset from a sample, px^2.
  double Squared(int sample, const Eigen::Vector3d& offset) const {
    return offset.dot(metric_[sample] * offset);
  }

 private:
  std::vector<Eigen::Matrix3d> metric_;
};

// An offset between two places of curves that run alike.
struct OffsetAlong {
  double along = 0;        // part along the first curve, world units
  Eigen::Vector3d across;  // where the second curve passes the plane across the first
};

// `tangent_a` and `tangent_b` point the same way. Exact to second order: the mean of the tangents
// of two points of a circle has the direction of their chord.
inline OffsetAlong OffsetBetween(const Eigen::Vector3d& offset, const Eigen::Vector3d& tangent_a,
                                 const Eigen::Vector3d& tangent_b) {
  const double along = offset.dot(tangent_a);
  const Eigen::Vector3d chord = tangent_a + tangent_b;
  return {along, offset - chord * (along / tangent_a.dot(chord))};
}

// Where the samples of a set agree. Arrays are per sample.
struct Consensus {
  std::vector<Eigen::Vector3d> position;  // on the ridge that the sample climbed to
  std::vector<Eigen::Vector3d> tangent;   // unit, of the ridge, in the direction of the sample's
  std::vector<int> num_views;             // primary views with a sample here, its own included
};

// Every sample climbs, across its tangent only, to the ridge of the density of samples near it
// (ours; algorithm/drawing.md#consensus): the samples of one edge, whatever view they come from,
// end on one curve. Time: O(n log n) in the number of samples, times the number of primary views.
Consensus FindConsensus(const SampleSet& samples, const ReprojectedMetric& metric,
                        const RunContext& context);

}  // namespace limn
