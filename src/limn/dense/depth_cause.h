// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/dense/depth_exam.h"
#include "limn/dense/sample_sights.h"

namespace limn {

// Why depths are not those of the drawing: what was done to them, if undone, makes them fit.
struct DepthCause {
  enum class Kind {
    kUnknown,  // nothing of the below: noise, another scene, other cameras
    kFactor,   // they are `factor` times too large
    kInverse,  // they are inverse depths, disparities
    kRays,     // they are distances from the camera's center, not along its axis
    kMirrored,
    kShifted,     // in the image, by `shift_px`
    kOtherViews,  // each fits another view
  };
  Kind kind = Kind::kUnknown;
  double factor = 1;
  Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();
  // For kOtherViews, an example: the depths of one view fit the other.
  ViewId depths_of = -1;
  ViewId fit_view = -1;
};

// Examines up to six of the views whose depths do not fit, and holds their depth images; does not
// compare them with other views (DepthWatch does). Time: their places times 441 shifts.
DepthCause FindDepthCause(const std::vector<ViewId>& unfit, const SurelySeen& seen,
                          const std::vector<View>& views, const DepthSource& depths,
                          const DenseOptions& options);

}  // namespace limn
