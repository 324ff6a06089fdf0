// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/support/edgel_index.h"
#include "limn/util/angles.h"
#include "limn/util/option_fields.h"

namespace limn {

struct RefinementOptions {
  // 0 leaves the drawing as it is.
  int num_rounds = 4;
  double max_distance_px = 1;
  // Well determined places prevail over it. Smaller is smoother.
  double bending_sigma = 0.08;

  // Spacing of the control points of a link, px: set by tests only. And of the samples that are
  // matched with edgels: set by what needs more.
  double control_spacing_px = 3;
  double sample_spacing_px = 3;
  // And within this angle, edgels pull at a link.
  double max_angle_deg = 15;
  // Views that must show a sample for its edgels to count.
  int min_views = 3;
  // Scale of the Cauchy loss, px: residuals much beyond it hardly count.
  double robust_residual_px = 0.5;
  // Correlation length of edgel errors in an image, px.
  double correlation_px = 4;

  // Of edgels that show a link.
  SupportGate Gate() const { return {max_distance_px, 1.0, max_angle_deg * kDeg}; }

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("num_rounds", self.num_rounds, Between(0, 100),
          "rounds of matching and fitting, 0 = no refinement");
    visit("max_distance_px", self.max_distance_px, Above(0, 100),
          "largest distance of an edgel that pulls at a link, px");
    visit("bending_sigma", self.bending_sigma, Between(1e-6, 1e4),
          "standard deviation of the change of direction over 1 px, rad");
  }
  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
