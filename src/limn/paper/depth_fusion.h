// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/sketch/depth_modes.h"
#include "limn/sketch/sketch_options.h"

namespace limn {

// One reconstruction of an edgel of the primary view. It lies on the edgel's ray, so its inverse
// depth determines it.
struct DepthCandidate {
  double inverse_depth = 0;
  // Change of inverse depth per px along the fragment, from the 3D tangent.
  double slope_per_px = 0;
  // Image motion per unit of inverse depth in the confirmation views, px.
  double px_per_inverse_depth = 0;
  // (sine of the triangulation angle x sine of the epipolar angle)^2: how well the depth is
  // determined.
  double weight = 0;
  // Supporting views, weighted by tangency.
  double weighted_support = 0;
  // Rank of the second view that made it.
  int second_rank = 0;
  // Whether the weighted support, too, is enough.
  bool certain = true;
};

// Robust averaging of all reconstructions of the edgels of one fragment (ECCV 2016, section 2;
// algorithm/paper.md#enhanced-sketch). At every vertex the candidates form modes (within 1.5 px of
// each other in the confirmation views); the modes are chosen jointly along the fragment by dynamic
// programming, which weighs their support against jumps between neighbors that their tangents do
// not explain; the candidates of the chosen mode are averaged by weight after dropping those
// beyond two robust standard deviations. With DepthAveraging::kPaper the mean of all candidates
// without those beyond two standard deviations is taken. `candidates[i]` belongs to vertex i. Time:
// vertices x (candidates log candidates + modes^2).
std::vector<FusedDepth> FuseDepths(const FragmentRays& fragment,
                                   const std::vector<std::vector<DepthCandidate>>& candidates,
                                   const SketchOptions& options);

}  // namespace limn
