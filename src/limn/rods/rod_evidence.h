// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "limn/rods/rod.h"
#include "limn/rods/rod_sights.h"
#include "limn/topology/topology_input.h"

namespace limn {

// How well a rod explains the edgels on its two sides, compared with two lines that are fixed in
// space, such as the edges of a strip or of a plate (algorithm/rods.md#rod-or-two-edges). The
// outlines of a rod are as far apart from wherever it is seen; those two lines are not.
struct RodEvidence {
  double rms_px = 0;  // of the distances of the edgels from the outlines, each at most 1 px
  int num_views = 0;  // with enough edgels
  // Logarithm of the ratio of the likelihoods, rod to lines: a sum over the views.
  double log_ratio = 0;
};

// Time: number of edgels.
RodEvidence CompareWithFixedLines(const TopologyInput& input, const Rod& rod,
                                  std::span<const RodPlace> places);

}  // namespace limn
