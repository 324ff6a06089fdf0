#pragma once

#include <cstdint>
#include <string>

#include "limn/model/curve_fragment.h"
#include "limn/model/image.h"

namespace limn {

// All distances are pixels of the stored image and all counts arc lengths, not numbers of edgels.
struct LinkingOptions {
  // Radius of the neighborhood in which curvelets are built, (1, 10]. Larger: more robust grouping
  // in noise, but worse at corners and parallel strands, and slower (R in Guo et al.).
  double neighbor_radius_px = 3.5;

  // Tolerance of a curvelet on edgel positions, across the curve, (0, 2]; never less than twice the
  // edgel's own position sigma, up to max_position_tolerance_px (dx).
  double position_tolerance_px = 0.4;
  double max_position_tolerance_px = 0.8;

  // Tolerance of a curvelet on edgel directions, (0, 45] (dt).
  double angle_tolerance_deg = 15;

  // Largest curvature of a curvelet, 1/px, > 0.
  double max_curvature = 0.2;

  // Shortest curvelet that links, first to last edgel, > 0. Larger: fewer chance links in noise.
  double min_curvelet_px = 3;

  // Where chains fork, "best" keeps the mutually best links; "hypotheses" compares the possible
  // continuations over up to 30 px. No better: algorithm/linking.md#what-was-measured.
  std::string forks = "best";

  // Fragments are joined over gaps up to this length where the continuation turns by no more than
  // max_bridge_angle_deg at either side, >= 0 and (0, 90].
  double max_bridge_px = 4;
  double max_bridge_angle_deg = 25;

  // Fragments are broken where two straight arms of this length, that begin 1.5 px on either side
  // of a vertex (smoothing rounds the corner itself), turn by more than the angle, (1, 50] and (0,
  // 180].
  double corner_arm_px = 5;
  double corner_angle_deg = 35;

  // A fragment is broken where the end of another one (of at least junction_stem_px) within this
  // distance heads for its interior at more than the angle, >= 0, >= 0 and [0, 90]. Because of
  // smoothing a stem ends about two detection sigmas before the bar.
  double junction_distance_px = 3.5;
  double junction_stem_px = 15;
  double junction_angle_deg = 30;

  // Shorter fragments are dropped, >= 0.
  double min_length_px = 6;

  // Tangents of linked edgels are re-estimated by a parabola fitted to this length of the fragment
  // on either side, (0, 50]. Larger: less noise, rounder bends.
  double tangent_arm_px = 4;

  bool ComparesForks() const { return forks == "hypotheses"; }

  // Throws OptionError.
  void Check() const;
};

// edgels = edgels_in_fragments + edgels_in_texture + edgels_unlinked + edgels_in_short_chains.
struct LinkingStats {
  int64_t edgels = 0;
  int64_t edgels_in_fragments = 0;
  // EdgeMap::texture.
  int64_t edgels_in_texture = 0;
  // In no chain of two edgels or more.
  int64_t edgels_unlinked = 0;
  // In chains shorter than min_length_px.
  int64_t edgels_in_short_chains = 0;
  int64_t curvelets = 0;
  int64_t graph_links = 0;
  int64_t changed_forks = 0;
  int64_t bridged_gaps = 0;
  int64_t corner_breaks = 0;
  int64_t junction_breaks = 0;
  int64_t short_chains = 0;
  int64_t fragments = 0;
  double fragments_length_px = 0;
};

struct LinkingResult {
  ImageCurves curves;
  LinkingStats stats;
};

// Groups the edgels of one image into curve fragments.
//
// 1. Around every edgel outside dense texture, curvelets: groups of neighbors that fit one circular
//    arc within the tolerances (Tamrakar and Kimia 2007; Guo, Kumar, Narayanan and Kimia, "A
//    multi-stage approach to curve extraction", ECCV 2014). Consecutive edgels of a curvelet vote
//    for a link.
// 2. Every edgel keeps the link with the most votes ahead and the one behind, where both ends
//    agree. Directed tangents must not oppose: a fragment has its bright side on one side
//    throughout. With forks = hypotheses, forks are then decided again: see ResolveForks.
// 3. Chains are broken at corners, joined over small gaps, broken at T junctions, and dropped if
// short.
// 4. Tangents of linked edgels are re-estimated along the fragment; their sense is kept.
//
// Works in the image as stored, that is, before ApplyLens. An edgel is in at most one fragment;
// fragments run along the tangents of their edgels and are ordered by their first edgel. Time:
// linear in edgels, about 2 microseconds each.
//
// `image`: the photograph in stored pixels, for the colors beside the chains that hypotheses
// compare; null: they are not compared.
LinkingResult LinkEdgels(EdgeMap edge_map, const LinkingOptions& options,
                         const Image* image = nullptr);

}  // namespace limn
