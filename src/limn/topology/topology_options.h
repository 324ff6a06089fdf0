#pragma once

namespace limn {

// What may be cut and joined in a drawing, while it is built and between the fits of the
// refinement. Lengths are in px where the curves are seen.
struct TopologyOptions {
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
  // Links shorter than this that hang by one end or by none are dropped.
  double min_link_length_px = 14;
  // Longest gap between an end and what it meets, and how far its line may miss that sideways.
  // Curves that were fitted to the images are allowed a part of both: see Reach.
  double max_junction_gap_px = 12;
  double max_junction_miss_px = 4;
  // Views in which the images must show that curves meet.
  int min_junction_views = 3;
  // Curves that differ by less than this are one edge where they lie side by side, and no junction
  // where they leave a node.
  double min_junction_angle_deg = 25;
  // Ends that turn by less than this go on in each other.
  double max_continuation_angle_deg = 30;
  // A link is covered when others run along this share of it.
  double covered_share = 0.8;
  // Longest edge that is found from its two ends alone.
  double max_short_edge_px = 30;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
