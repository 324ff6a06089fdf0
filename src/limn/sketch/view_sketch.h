// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/edgel_fate.h"
#include "limn/sketch/depth_modes.h"

namespace limn {

// Depths of the samples of a fragment, and the reasons where there is none.
struct DepthProfile {
  std::vector<FusedDepth> depths;
  std::vector<EdgelFate> fates;  // kNoPartner, kTooFewViews or kInconsistent where there is none
};

// All that is found out for the sketch of a view, except its support.
struct ViewDepths {
  double spacing_px = 0;                  // of the places where depths are sought (SpacedVertices)
  int sample_step = 1;                    // vertices of a fragment per sample of its curves
  std::vector<DepthProfile> of_fragment;  // empty for those that are too short to be matched
};

// The part of a sketch that comes from one primary view.
struct ViewSketch {
  std::vector<Curve3D> curves;   // anchored in this view, by fragment
  std::vector<EdgelFate> fates;  // per edgel of the view
};

}  // namespace limn
