// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// The paper's drawing (ECCV 2016, section 3). Defaults are the paper's and its authors' program's
// (algorithm/paper.md).
struct PaperOptions {
  // tau_eps.
  int strong_link_views = 3;
  int dense_link_views = 2;
  // tau_sl.
  int min_strong_links = 5;
  int max_averaging_rounds = 300;
  // tau_merge.
  double merge_distance_px = 0.7;
  // tau_branch. Bubbles whose ends are nearer are absorbed.
  double min_branch_length_px = 10;
  // tau_junc. A vertex stands for samples up to this far along the curve.
  double junction_distance_px = 4;

  // Set by tests only: gaps in the overlap of two curves up to this length are filled, overlaps
  // below it removed, px.
  double overlap_regularity_px = 9;
  // Averaging stops when no sample moves by more than this, px.
  double averaging_tolerance_px = 0.05;
  // Largest angle between the directions of merged samples.
  double max_link_angle_deg = 25;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("strong_link_views", self.strong_link_views, Between(1, 1e6),
          "views with shared edgels for a strong link");
    visit("dense_link_views", self.dense_link_views, Between(1, 1e6), "the same for a dense link");
    visit("min_strong_links", self.min_strong_links, Between(1, 1e9),
          "strong links that link two curves");
    visit("max_averaging_rounds", self.max_averaging_rounds, Between(0, 1000),
          "rounds after which averaging stops if samples still move");
    visit("merge_distance_px", self.merge_distance_px, Above(0, 100),
          "samples within this of a link belong to it, px");
    visit("min_branch_length_px", self.min_branch_length_px, Between(0, 1e5),
          "shorter stubs are not branches, px");
    visit("junction_distance_px", self.junction_distance_px, Between(0, 1000),
          "ends within this meet in a node, px");
  }
  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
