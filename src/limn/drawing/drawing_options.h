#pragma once

#include <string>

#include "limn/support/edgel_index.h"
#include "limn/topology/topology_options.h"

namespace limn {

struct DrawingOptions {
  // How samples become links: "traced" follows the ridges of the consensus of all samples (ours);
  // "merged" builds the paper's consistency networks, averages and merges in its place; "paper"
  // does so with the sketch as it is, and nothing else: no re-triangulation, completion, refinement
  // or belief (ECCV 2016).
  std::string method = "traced";
  // Edgels within this distance across the edge and this angle support a sample.
  double max_support_distance_px = 1.0;
  double max_support_angle_deg = 15;

  // Re-triangulation: residuals beyond this count linearly (Huber), px.
  double robust_residual_px = 0.6;
  // Strength of the smoothing along a curve: standard deviation of the change of direction from one
  // sample to the next, px. Smaller is smoother; well determined samples prevail over it.
  double bending_sigma_px = 0.03;
  // Views, the primary one included, that must support a sample after re-triangulation: this share
  // of those that contain it, at least min and at most max.
  double supporting_views_share = 0.25;
  int min_supporting_views = 3;
  int max_supporting_views = 5;

  // Local consistency network: samples that share edgels in this many views are strongly (tau_eps)
  // or densely linked. With the defaults the two coincide; the paper's are 3 and 2.
  int strong_link_views = 3;
  int dense_link_views = 3;
  // Curve consistency network: two curves are linked by this many strong links (tau_sl; method
  // "paper"), or by strong links over this arc length, px. Shorter pieces are dropped after
  // re-triangulation.
  int min_strong_links = 5;
  double min_linked_length_px = 4;
  // Gaps in the overlap of two curves up to this length are filled, overlaps below it removed, px.
  double overlap_regularity_px = 9;
  // Largest angle between the directions of merged samples, and of linked ones except in the method
  // "paper".
  double max_link_angle_deg = 25;

  // Averaging stops when no sample moves by more than this, px, or after this many rounds.
  double averaging_tolerance_px = 0.05;
  int max_averaging_rounds = 10;

  // A sample belongs to a link if their reprojections are within this distance, px (tau_merge).
  double merge_distance_px = 0.7;
  // Stubs shorter than this are not branches, and bubbles whose ends are nearer are absorbed, px
  // (tau_branch).
  double min_branch_length_px = 10;
  // A run that meets a link within this distance of its end ends at the node there, and a vertex
  // stands for samples up to this far along the curve, px (tau_junc).
  double junction_distance_px = 4;

  // Tracing, edits after it, and edits between the fits of the refinement.
  TopologyOptions topology = {};

  // Whether nothing is done that is not in the paper.
  bool IsPaper() const { return method == "paper"; }
  SupportGate Gate() const {
    return {max_support_distance_px, 1.0, max_support_angle_deg * M_PI / 180};
  }
  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
