// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/sketch/view_selection.h"
#include "limn/support/edgel_index.h"
#include "limn/util/angles.h"
#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// How all reconstructions of an edgel become one in the enhanced sketch: by modes chosen jointly
// along the fragment (ours), or as in ECCV 2016, section 2: their mean without those farther from
// it than two standard deviations of their pairwise distances.
enum class DepthAveraging { kRobust, kPaper };

struct SketchOptions {
  ViewSelectionOptions view_selection;

  // tau_d and tau_theta of the paper.
  double max_support_distance_px = 1.5;
  double max_support_angle_deg = 15;
  // Few, for any number of views: many true edges are visible in no more, and the drawing later
  // verifies whole links.
  int min_supporting_views = 3;
  // Lower finds smaller details and more accidental matches.
  double min_fragment_length_px = 12;
  // Of the enhanced sketch. What it says of support applies to the swept sketch, too: see
  // WithSupportRule.
  DepthAveraging averaging = DepthAveraging::kRobust;
  // Original sketch only (whole-curve support as published; lengths as for 640 x 360 images): the
  // total at which its authors cut their results; pairs with fewer than 5 confirmation views need a
  // fifth of it per view.
  int original_min_inliers_total = 125;
  bool original_exhaustive_pairs = false;

  // Original sketch, and enhanced sketch with the averaging of the paper: of rival hypotheses one
  // counts if it has more than this times the support of every other. Set by tests only.
  double first_to_second_ratio = 1.5;
  // A sample is supported if enough views are, each counted by its tangency weight, at whatever
  // angles. No option: WithSupportRule sets it.
  bool by_weight_alone = false;

  SupportGate Gate() const { return {max_support_distance_px, 1.0, max_support_angle_deg * kDeg}; }

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("min_fragment_length_px", self.min_fragment_length_px, Between(3, 1e5),
          "shorter fragments are not matched, px");
    visit("max_support_distance_px", self.max_support_distance_px, Above(0, 100),
          "largest distance of a supporting edgel across the edge, px");
    visit("max_support_angle_deg", self.max_support_angle_deg, Above(0, 90),
          "and within this angle, deg");
    visit("min_supporting_views", self.min_supporting_views, Between(1, 1e6),
          "confirmation views that must support a sample, all others of a scene with fewer");
    visit("averaging", self.averaging, OneOf({"robust", "paper"}),
          "enhanced mode: robust, or the paper's section 2");
    visit("original_min_inliers_total", self.original_min_inliers_total, Between(0, 1e9),
          "original mode: inliers over all confirmation views, of 5 or more, that a curve needs");
    visit("original_exhaustive_pairs", self.original_exhaustive_pairs, OnOrOff(),
          "original mode: match all pairs of views, not the selected ones");
  }
  // Throws OptionError.
  void Check() const {
    view_selection.Check();
    CheckFields(*this);
  }
};

}  // namespace limn
