// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct SurfaceOptions {
  double min_length_px = 6;
  double plane_tolerance_px = 2;
  double max_bridge_px = 10;
  // At most as long as the link itself.
  double max_extension_px = 150;
  // The width is twice the area by the perimeter.
  double min_width_px = 2;
  double min_shown_share = 0.7;
  int min_views = 2;
  double min_seen_share = 0.5;

  // Prior evidence for every face, added to that from occlusion; natural logarithm. Set by tests
  // only.
  double prior_evidence = 2;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("min_length_px", self.min_length_px, Between(1, 1e4), "shorter links bound no face, px");
    visit("plane_tolerance_px", self.plane_tolerance_px, Above(0, 100),
          "the links of a face are within this of its plane, px");
    visit("max_bridge_px", self.max_bridge_px, Between(0, 1e3),
          "longest gap between links that is bridged where a face needs it, px");
    visit("max_extension_px", self.max_extension_px, Between(0, 1e4),
          "longest straight extension of a link to another, px");
    visit("min_width_px", self.min_width_px, Between(0, 1e4), "narrower faces are left out, px");
    visit("min_shown_share", self.min_shown_share, Above(0, 1),
          "share of the border around a place that a view must show to see the place");
    visit("min_views", self.min_views, Between(1, 1e4), "views that must see a place of a face");
    visit("min_seen_share", self.min_seen_share, Between(0, 1),
          "share of the places of a face that must be seen");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
