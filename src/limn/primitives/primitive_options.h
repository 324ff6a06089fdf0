// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// Within this distance of a node, px, the edges of its links run into one another: samples there
// get little weight, and the node moves, by at most this, to where the shapes of its links meet.
inline constexpr double kEndZonePx = 4;
// Correlation length of the errors of a drawn curve in the images, px: that of its smoothing.
inline constexpr double kCurveCorrelationPx = 12;

struct PrimitiveOptions {
  double max_residual_px = 1;

  // Standard deviation of a drawn curve in the images, px: weighs a better fit against more
  // parameters. Set by tests only.
  double noise_px = 0.3;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("max_residual_px", self.max_residual_px, Above(0, 1000),
          "largest distance of a primitive from its link, RMS over the views, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
