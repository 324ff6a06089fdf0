#pragma once

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
  // Of these, the one that tells noise from wrong pairs: the median, but of few pairs a greater one
  // (see FitPositions).
  double typical_scaled_residual = 0;
  // Standard errors: of the direction of the target's z axis, of the direction of its x axis around
  // z (pi where pairs on a line leave it open), and of the scale, relative.
  double up_error_rad = 0;
  double heading_error_rad = 0;
  double scale_error = 0;
};

// Three have too few residuals to tell how wrong the fit is.
constexpr size_t kMinPositions = 4;

// The similarity that brings most sources to their targets: the best by its typical residual of
// some that three pairs each give and of the one of least squares, then that of least squares of
// the pairs within four standard deviations of it, iterated; residuals are compared by the
// accuracies of their pairs. Typical is the median, but at least the seventh smallest: all pairs
// but seven may be wrong if these are fewer than half. Of up to seven all count, and a wrong one
// shows in the errors that are told. Nothing for fewer than kMinPositions pairs, or sources all at
// one place. The same pairs give the same result. Linear time.
std::optional<PositionFit> FitPositions(const std::vector<PointPair>& pairs);

}  // namespace limn
