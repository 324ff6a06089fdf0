#pragma once

#include <string>

#include "limn/sketch/view_selection.h"
#include "limn/support/edgel_index.h"
#include "limn/util/angles.h"

namespace limn {

struct SketchOptions {
  ViewSelectionOptions view_selection;

  // Fragments shorter than this are not matched, px of arc length. Lower finds smaller details and
  // more accidental matches.
  double min_fragment_length_px = 12;
  // Shortest stretch over which two fragments must correspond, px of arc length in the primary
  // view.
  double min_overlap_px = 5;

  // Spacing of the samples of a fragment for which depths are sought, px; edgels between them are
  // interpolated. Larger is faster and coarser.
  double sample_spacing_px = 2;

  // Edge support (tau_d, tau_theta): a reprojected sample is supported by an edgel within this
  // distance across the edge and this angle.
  double max_support_distance_px = 1.5;
  double max_support_angle_deg = 15;
  // Half length of the stretch of curve that decides whether a view supports a sample, px.
  double support_window_px = 4;
  // Share of the samples in that stretch which must be supported.
  double min_window_support = 0.7;
  // Confirmation views that must support a sample. Few, for any number of views: many true edges
  // are visible in no more, and the drawing later verifies whole links. Requiring a share of the
  // views here, up to 6, lost more true curves than it removed false ones
  // (algorithm/sketch.md#what-was-measured).
  int min_supporting_views = 3;
  // Epipolar tangency: a view whose epipolar line makes an angle below the first value with the
  // curve gets min_tangency_weight, one above the second full weight.
  double min_epipolar_angle_deg = 3;
  double max_epipolar_angle_deg = 15;
  double min_tangency_weight = 0.1;

  // Enhanced sketch: how all reconstructions of an edgel become one. "robust" chooses modes jointly
  // along the fragment (ours); "paper" takes their mean without those farther from it than two
  // standard deviations of their pairwise distances, and a view's support counts by its tangency
  // weight (ECCV 2016, section 2).
  std::string averaging = "robust";
  // Original sketch, and enhanced sketch with averaging "paper": of rival hypotheses one counts if
  // it has more than this times the support of every other.
  double first_to_second_ratio = 1.5;

  // Two reconstructions of one edgel belong together when they reproject within this distance.
  double depth_gate_px = 1.5;
  // Gaps in support up to this length do not break a curve, px.
  double max_unsupported_gap_px = 2.5;
  // An epipolar-tangent portion up to this length is interpolated between its ends, px.
  double max_interpolated_gap_px = 30;
  // Shorter pieces are dropped, px of arc length.
  double min_piece_length_px = 8;

  // Swept sketch only: number of confirmation views in which depths are sought, the most useful
  // first, and spacing of the samples, px.
  int max_sweep_views = 16;
  double sweep_spacing_px = 3;

  // Original sketch only (whole-curve support as published; lengths as for 640 x 360 images). The
  // total is the one at which its authors cut their results; pairs with fewer than 5 confirmation
  // views need a fifth of it per view.
  double original_min_fragment_length_px = 20;
  double original_min_epipolar_angle_deg = 10;
  int original_min_inliers_view = 15;
  int original_min_inliers_total = 125;
  // Whether all other views are second views of a view, instead of the selected ones.
  bool original_exhaustive_pairs = false;

  bool AveragesAsPaper() const { return averaging == "paper"; }
  SupportGate Gate() const { return {max_support_distance_px, 1.0, max_support_angle_deg * kDeg}; }
  void Check() const;
};

}  // namespace limn
