#pragma once

namespace limn {

// Limits for tracing and every edit of a drawing's topology, while it is built
// (algorithm/drawing.md#tracing, algorithm/topology.md) and between the fits of the refinement.
// Lengths are in px, that is, in footprints.
struct TopologyOptions {
  // Tracing: curves start where samples of this many primary views agree, continue where at least
  // the second number do, and bridge gaps up to this length.
  int min_seed_views = 2;
  int min_traced_views = 1;
  double max_tracing_gap_px = 6;
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
  // Shorter loops and links with a free end are dropped.
  double min_link_length_px = 14;
  // A link is extended from a free end across gaps in the images up to this length.
  double max_continuation_gap_px = 6;
  // Longest gap between an end and what it meets, and the largest sideways distance from its line.
  // Links that were fitted to the images get less: see Reach.
  double max_junction_gap_px = 12;
  double max_junction_miss_px = 4;
  // Number of views that must show that two curves meet.
  int min_junction_views = 3;
  // Curves side by side are one edge below this angle. Links that leave a node at a smaller angle
  // form no junction.
  double min_junction_angle_deg = 25;
  // Two ends continue each other if the turn between them is smaller than this.
  double max_continuation_angle_deg = 30;
  // A link is removed if others run along this share of it.
  double covered_share = 0.8;
  // Longest edge inferred from its two end points alone.
  double max_short_edge_px = 30;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
