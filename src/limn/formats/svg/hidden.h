// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"
#include "limn/visibility/depth_image.h"
#include "limn/visibility/orthographic_depth.h"

namespace limn {

// Whether a point is hidden in the picture. Empty: nothing is.
using IsHidden = std::function<bool(const Eigen::Vector3d& point_in_world)>;

// Hidden is what is behind a view's depth image (of a depth map, cloud or mesh) by more than
// `tolerance_px` pixel footprints, in its pixel and within `margin_px` to all sides, so that curves
// that are a pixel off do not vanish behind the outline beside them.
IsHidden HiddenInView(View view, DepthImage depth, double tolerance_px = 4, double margin_px = 1);

// The same in parallel projection, for sheets; tolerance and margin in depth pixels.
IsHidden HiddenOnSheet(OrthographicDepth depth, double tolerance_px = 4, double margin_px = 1);

// A part of a curve, in the curve's own parameter.
struct ShownRun {
  double from = 0;
  double to = 0;
  bool hidden = false;
};

// A position on a curve and the length of the drawn curve up to it.
struct CurveSample {
  double t = 0;
  double length_px = 0;
};

// The alternating visible and hidden parts of a curve, from its ascending samples; borders between
// samples are found by bisection. Parts shorter than `min_run_px` are merged with their neighbors,
// first hidden, then visible ones, so that single wrong depths leave no gaps or fragments.
// Precondition: at least two samples.
std::vector<ShownRun> FindRuns(const std::function<Eigen::Vector3d(double)>& point_at,
                               const std::vector<CurveSample>& samples, const IsHidden& is_hidden,
                               double min_run_px);

}  // namespace limn
