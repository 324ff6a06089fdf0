#pragma once

#include "limn/support/edgel_index.h"

namespace limn {

struct DrawingOptions {
  // Edgels within this distance across the edge and this angle support a sample.
  double max_support_distance_px = 1.0;
  double max_support_angle_deg = 15;

  // Re-triangulation: residuals beyond this count linearly (Huber), px.
  double robust_residual_px = 0.6;
  // Strength of the smoothing along a curve: the standard deviation allowed for the change of
  // direction from one sample to the next, px. Smaller is smoother; data that determine a sample
  // well win.
  double bending_sigma_px = 0.03;
  // Views, the anchor included, that must still support a sample after re-triangulation: this share
  // of those that contain it, but at least min and at most max.
  double supporting_views_share = 0.25;
  int min_supporting_views = 3;
  int max_supporting_views = 5;

  // Local consistency network: samples that share edgels in this many views are strongly (tau_eps)
  // or densely linked.
  int strong_link_views = 3;
  int dense_link_views = 3;
  // Curve consistency network: two curves are linked by strong links over this arc length (tau_sl),
  // px.
  double min_linked_length_px = 4;
  // Gaps in the overlap of two curves up to this length are filled, overlaps below it removed, px.
  double overlap_regularity_px = 9;
  // Directions of linked curves differ by less than this.
  double max_link_angle_deg = 25;

  // Averaging stops when no sample moves by more than this, px, or after the number of rounds.
  double averaging_tolerance_px = 0.05;
  int max_averaging_rounds = 10;

  // A sample belongs to a link when their reprojections are this near, px (tau_merge).
  double merge_distance_px = 0.7;
  // Primary views whose curves must agree with a link, in the mean over its length, since single
  // samples may be weak where the link is strong: this share of the views that contain it, but at
  // least min and at most max.
  double primary_views_share = 0.1;
  double min_primary_views = 2;
  double max_primary_views = 4;
  // Other links are believed when edgels that none of those explains run along them in so many more
  // views than by chance: again a share, at least min and at most max.
  double own_views_share = 0.12;
  double min_own_views = 3;
  double max_own_views = 6;
  // Stubs shorter than this are not branches, px (tau_branch).
  double min_branch_length_px = 10;
  // Links shorter than this that hang by one end or by none are dropped, px.
  double min_link_length_px = 14;
  // Link ends (and junctions) this near meet in one node, px (tau_junc).
  double junction_distance_px = 4;
  // Largest gap bridged between link ends whose tangent lines meet, px, and how near they must
  // pass.
  double max_junction_gap_px = 12;
  double max_junction_miss_px = 4;
  // Longest edge that is found from its two ends alone, px.
  double max_short_edge_px = 30;
  // Views in which the images must show that the curves meet.
  int min_junction_views = 3;
  // Links that leave a node nearer to each other than this are strands of one edge, no junction.
  double min_junction_angle_deg = 25;
  // Two links that meet alone in a node and turn by less than this are one link.
  double max_continuation_angle_deg = 30;

  SupportGate Gate() const {
    return {max_support_distance_px, 1.0, max_support_angle_deg * M_PI / 180};
  }
  void Check() const;
};

}  // namespace limn
