#pragma once

namespace limn {

struct RefinementOptions {
  // Rounds of matching and fitting, at most 100; 0 leaves the drawing as it is.
  int num_rounds = 4;
  // Spacing of the control points of a link, px.
  double control_spacing_px = 3;
  // Edgels within this distance across the edge and this angle pull at a link.
  double max_distance_px = 1;
  double max_angle_deg = 15;
  // Half length of the stretch around a sample that decides whether a view shows the link there,
  // px, and the share of it that edgels must cover.
  double support_window_px = 6;
  double min_window_support = 0.5;
  // Views that must show a sample for its edgels to count.
  int min_views = 3;
  // Scale of the Cauchy loss, px: residuals much beyond it hardly count.
  double robust_residual_px = 0.5;
  // Correlation length of edgel errors in an image, px.
  double correlation_px = 4;
  // Strength of the smoothing: standard deviation of the change of direction over 1 px, growing
  // with the root of the length. Smaller is smoother; well determined places prevail over it.
  double bending_sigma = 0.08;

  // Also refine the poses of the views and one focal length per camera, from curves and points.
  bool refine_poses = false;

  void Check() const;
};

}  // namespace limn
