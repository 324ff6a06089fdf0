#pragma once

#include "limn/support/edgel_index.h"
#include "limn/util/angles.h"

namespace limn {

// The paper's drawing (ECCV 2016, section 3). Defaults are the paper's and its authors' program's
// (algorithm/paper.md).
struct PaperOptions {
  // Edgels within this distance across the edge and this angle support a sample.
  double max_support_distance_px = 1.0;
  double max_support_angle_deg = 15;

  // Local consistency network: samples that share edgels in this many views are strongly (tau_eps)
  // or densely linked.
  int strong_link_views = 3;
  int dense_link_views = 2;
  // Curve consistency network: two curves are linked by this many strong links (tau_sl).
  int min_strong_links = 5;
  // Gaps in the overlap of two curves up to this length are filled, overlaps below it removed, px.
  double overlap_regularity_px = 9;

  // Averaging stops when no sample moves by more than this, px, or after this many rounds.
  double averaging_tolerance_px = 0.05;
  int max_averaging_rounds = 300;

  // Largest angle between the directions of merged samples.
  double max_link_angle_deg = 25;
  // A sample belongs to a link if their reprojections are within this distance, px (tau_merge).
  double merge_distance_px = 0.7;
  // Stubs shorter than this are not branches, and bubbles whose ends are nearer are absorbed, px
  // (tau_branch).
  double min_branch_length_px = 10;
  // A run that meets a link within this distance of its end ends at the node there, and a vertex
  // stands for samples up to this far along the curve, px (tau_junc).
  double junction_distance_px = 4;

  SupportGate Gate() const { return {max_support_distance_px, 1.0, max_support_angle_deg * kDeg}; }
  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
