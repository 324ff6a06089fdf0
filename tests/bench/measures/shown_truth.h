// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve_fragment.h"
#include "limn/model/curve_set.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

struct ShownTruthOptions {
  // A view shows a point of the truth if a linked edgel is within this distance across the edge,
  // px, and within this angle (for points of curves). Occlusion is ignored, so accidental matches
  // count.
  double max_distance_px = 1.5;
  double max_angle_deg = 15;
  // Number of views that must show it.
  int min_views = 3;
  // Only points inside are used. None: all.
  std::optional<Eigen::AlignedBox3d> region;

  void Check() const;
};

// The points of the truth, sampled every half pixel footprint, that the image curves show: their
// recall is an upper bound for any reconstruction from the same image curves. Throws OptionError.
// Time: points times views.
CurveSet ShownTruth(const CurveSet& truth, const std::vector<View>& views,
                    const std::vector<ImageCurves>& curves, const ShownTruthOptions& options,
                    const RunContext& context);

}  // namespace limn
