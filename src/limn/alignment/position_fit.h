// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limn/geometry/similarity3.h"

namespace limn {

// A point in two frames.
struct PointPair {
  Eigen::Vector3d source = Eigen::Vector3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  // Inverse variance of the target, in any unit that is the same for all.
  double weight = 1;
};

struct PositionFit {
  Similarity3d target_from_source;
  // Distances that the fit leaves, in the unit of the target: per pair, and their median.
  std::vector<double> residuals;
  double median_residual = 0;
  // Times the square root of the pair's weight: comparable where pairs differ in accuracy.
  std::vector<double> scaled_residuals;
  // The one of these that separates noise from wrong pairs: the median, or a larger one if there
  // are few pairs (see FitPositions).
  double typical_scaled_residual = 0;
  // Per pair 1 if it has no say in the fit, since it is wrong; and their number.
  std::vector<uint8_t> is_rejected;
  size_t num_rejected = 0;
  // Standard errors: of the direction of the target's z axis, of the direction of its x axis around
  // z (pi where pairs on a line leave it open), and of the scale, relative.
  double up_error_rad = 0;
  double heading_error_rad = 0;
  double scale_error = 0;
};

// With three pairs, too few residuals are left to judge the fit.
constexpr size_t kMinPositions = 4;

// The similarity that brings most sources to their targets. It starts from the best, by typical
// residual, among fits to random triples and the least-squares fit to all pairs, then repeats least
// squares over the pairs within four standard deviations; residuals are scaled by the accuracies of
// their pairs. The typical residual is the median, but at least the seventh smallest: all but seven
// pairs may be wrong if these are fewer than half. Of five to seven pairs one may be wrong, if the
// others fit far better without it; more show in the reported errors. Nothing for fewer than
// kMinPositions pairs, or sources all at one place. The same pairs give the same result. Linear
// time.
std::optional<PositionFit> FitPositions(const std::vector<PointPair>& pairs);

}  // namespace limn
