// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// Limits for every edit of a drawing's topology, while it is built (algorithm/topology.md) and
// between the fits of the refinement. Lengths are in px, that is, in footprints.
struct TopologyOptions {
  // Shorter loops and links with a free end are dropped.
  double min_link_length_px = 14;
  // Between an end and what it meets. Links that were fitted to the images get less: see Reach.
  double max_junction_gap_px = 12;
  double max_continuation_angle_deg = 30;
  double max_short_edge_px = 30;

  // The others are set by tests only.
  // Number of primary views whose curves must agree with a link, averaged over its length: this
  // share of the views that contain the link, at least min and at most max.
  double primary_views_share = 0.1;
  double min_primary_views = 2.5;
  double max_primary_views = 4;
  // A link that fails this is kept if edgels that no certain link explains run along it in this
  // many more views than chance predicts: again a share, at least min and at most max.
  double own_views_share = 0.12;
  double min_own_views = 2;
  double max_own_views = 6;
  // A link is extended from a free end across gaps in the images up to this length.
  double max_continuation_gap_px = 6;
  // Largest sideways distance of what an end meets from its line.
  double max_junction_miss_px = 4;
  // Number of views that must show that two curves meet.
  int min_junction_views = 3;
  // Curves side by side are one edge below this angle. Links that leave a node at a smaller angle
  // form no junction.
  double min_junction_angle_deg = 25;
  // A link is removed if others run along this share of it.
  double covered_share = 0.8;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("min_link_length_px", self.min_link_length_px, Between(0, 1e5),
          "shorter loose links are dropped, px");
    visit("max_junction_gap_px", self.max_junction_gap_px, Between(0, 1000),
          "longest gap between ends that meet, px");
    visit("max_continuation_angle_deg", self.max_continuation_angle_deg, Between(0, 180),
          "two ends that turn by less continue each other, deg");
    visit("max_short_edge_px", self.max_short_edge_px, Between(0, 1e4),
          "longest edge inferred from its two ends alone, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
