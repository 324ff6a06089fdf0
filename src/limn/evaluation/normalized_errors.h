// SPDX-License-Identifier: BSD-3-Clause
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
  // A vertex farther from the truth is false, not inaccurate, footprints.
  double max_distance = 2;
  // False vertices within this distance of a don't-care curve are ignored, footprints.
  double dont_care_distance = 2;
};

// How well the sigmas of a drawing predict its errors. The error of a vertex is its offset across
// the nearest true curve. The normalized square, error^2 / (2 sigma^2) since there are two
// directions across, has mean 1 if the sigmas are right, and median ln 2 if errors are also normal.
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
