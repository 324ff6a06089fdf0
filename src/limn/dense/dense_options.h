// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct DenseOptions {
  // A curve farther away is behind the surface. Depths are several times less accurate than
  // positions across the line of sight.
  double depth_tolerance_px = 5;
  double near_px = 2;

  // Spacing of the samples along a link, footprints. No option.
  double sample_spacing_px = 1;
  // A link seen, averaged over its samples, by this many of its supporting views is never behind
  // the surface: other views may support it by what stands in front of it. Set by tests only.
  double enough_visible_views = 3;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("depth_tolerance_px", self.depth_tolerance_px, Above(0, 1e4),
          BasicOption("a curve this near in depth is on the surface, footprints"));
    visit("near_px", self.near_px, Above(0, 1000),
          "dense points within this are at the same place, footprints");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
