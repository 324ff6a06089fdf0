#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "limn/model/curve_set.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

struct NormalizedErrorOptions {
  // Only vertices inside count. None: all.
  std::optional<Eigen::AlignedBox3d> region;
  // A vertex farther from the truth is no inaccurate vertex but a false one, footprints.
  double max_distance = 2;
  // False vertices this near to a don't-care curve count nowhere, footprints.
  double dont_care_distance = 2;
};

// How well the sigmas of a drawing tell its errors. Of every vertex the error is its offset across
// the nearest true curve, and its square over that of two sigmas, one for each direction across, is
// the normalized square: 1 in the mean if the sigmas are right, ln 2 in the median if errors are
// normal.
struct NormalizedErrors {
  int num_inliers = 0;  // vertices with a sigma near the truth
  int num_false = 0;    // others with a sigma
  // Mean of the normalized squares. Absent without such vertices.
  std::optional<double> variance;
  std::optional<double> variance_with_false;
  // Median of the normalized squares of the inliers / ln 2: the variance that a normal distribution
  // with this median would have.
  std::optional<double> median_variance;
};

// Time: O(n log n) in the true length in footprints and the number of vertices; linear in the
// number of views. Precondition: there is a view.
NormalizedErrors MeasureNormalizedErrors(const DrawingGraph& drawing, const CurveSet& truth,
                                         const CurveSet& dont_care, const std::vector<View>& views,
                                         const NormalizedErrorOptions& options);

}  // namespace limn
