// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// Where chains fork: kBest keeps the mutually best links, kHypotheses compares the ways to go on
// over up to 30 px. Measured, no better: algorithm/linking.md#what-was-measured.
enum class ForkChoice { kBest, kHypotheses };

// All distances are pixels of the stored image and all counts arc lengths, not numbers of edgels.
struct LinkingOptions {
  ForkChoice forks = ForkChoice::kBest;
  // 0 = no gap is bridged.
  double max_bridge_px = 4;
  // Also how far a break at a junction stays from ends and other breaks.
  double min_length_px = 6;

  // Of curvelets; set by tests only. Radius of the neighborhood in which they are built (R in Guo
  // et al.): larger is more robust in noise, but worse at corners and parallel strands, and slower.
  double neighbor_radius_px = 3.5;
  // Tolerance on edgel positions, across the curve; never less than twice the edgel's own position
  // sigma, up to the maximum (dx).
  double position_tolerance_px = 0.4;
  double max_position_tolerance_px = 0.8;
  // Tolerance on edgel directions (dt).
  double angle_tolerance_deg = 15;
  // 1/px.
  double max_curvature = 0.2;
  // Shortest curvelet that links, first to last edgel. Larger: fewer chance links in noise.
  double min_curvelet_px = 3;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("forks", self.forks, OneOf({"best", "hypotheses"}),
          "how forks are decided: by links, or by comparing fragments");
    visit("max_bridge_px", self.max_bridge_px, Between(0, 100),
          "longest gap over which fragments are joined, px");
    visit("min_length_px", self.min_length_px, Between(0, 1e5),
          "shorter fragments are dropped, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

}  // namespace limn
