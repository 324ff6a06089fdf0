// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/linking/link_graph.h"
#include "limn/linking/linking_options.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/image.h"

namespace limn {

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
  // The whole graph, sorted by (a, b). It includes links that no fragment uses.
  std::vector<EdgelLink> link_graph;
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
//    throughout. With ForkChoice::kHypotheses, forks are then decided again: see ResolveForks.
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
