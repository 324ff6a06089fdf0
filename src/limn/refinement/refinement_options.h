#pragma once

namespace limn {

struct RefinementOptions {
  // Rounds of matching and fitting; 0 leaves the drawing as it is.
  int num_rounds = 4;
  // Spacing of the control points of a link, px.
  double control_spacing_px = 3;
  // Edgels within this distance across the edge and this angle pull at a link.
  double max_distance_px = 1;
  double max_angle_deg = 15;
  // Half length of the stretch of a link that decides whether a view shows it there, px, and the
  // share of the stretch that edgels must cover.
  double support_window_px = 6;
  double min_window_support = 0.5;
  // Views that must show a place of a link for its edgels to count.
  int min_views = 3;
  // Residuals much beyond this hardly count (Cauchy), px.
  double robust_residual_px = 0.5;
  // Errors of edgels of one image this near to each other are the same error, px.
  double correlation_px = 4;
  // Strength of the smoothing: the standard deviation allowed for the change of direction over a
  // stretch of one px, growing with the root of its length. Smaller is smoother; data that
  // determine a place well win.
  double bending_sigma = 0.08;

  // Refine the poses of the views and one focal length per camera too, from curves and points.
  bool refine_poses = false;

  void Check() const;
};

}  // namespace limn
