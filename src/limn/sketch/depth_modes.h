// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/sketch/fragment_rays.h"

namespace limn {

// The fused depth of one edgel. The other fields count only if has_depth is true.
struct FusedDepth {
  bool has_depth = false;
  bool certain = false;
  double inverse_depth = 0;
  double slope_per_px = 0;
  double weight = 0;  // sum over the averaged candidates
  double px_per_inverse_depth = 0;
};

// A possible depth of an edgel.
struct DepthMode {
  double score = 0;  // in supporting views
  FusedDepth depth;
};

// Chooses one mode per vertex, or none (-1), jointly along a fragment by dynamic programming, which
// weighs scores against jumps between neighbors that their slopes do not explain. `modes[i]`
// belongs to vertex i. The first vertex of a closed fragment is not tied to the last. Time:
// vertices x modes^2.
std::vector<int> ChooseModes(const FragmentRays& fragment,
                             const std::vector<std::vector<DepthMode>>& modes);

}  // namespace limn
