// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// Shorter links follow no regularity, px: their directions are noise.
inline constexpr double kMinRegularLengthPx = 20;

struct RegularityOptions {
  double max_shift_px = 0.5;
  // Links whose residuals would grow more are let go.
  double max_growth_px = 0.1;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("max_shift_px", self.max_shift_px, Between(0, 1000),
          "ends of a link move by at most this to follow a regularity, px");
    visit("max_growth_px", self.max_growth_px, Between(0, 1000),
          "a link's residual grows by at most this, RMS over the views, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
