// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/linking/link_graph.h"
#include "limn/linking/linking_options.h"
#include "limn/model/curve_fragment.h"

namespace limn {

// The geometric cleanup of chains. Each function returns the number of its changes.

// Open chains that are known to have no corner.
struct SmoothChains {
  std::vector<EdgelId> last_of;  // their last edgels by their first; kInvalidEdgel = none
};

// Breaks chains at corners: vertices where the arms turn by more than a corner needs and more
// sharply than the curve beside them (so that small circles stay whole). Chains in `known` are
// skipped; those found to have no corner are added to it.
int BreakAtCorners(const std::vector<Edgel>& edgels, SmoothChains* known, Chaining* chaining);

// Joins the end of a chain to the beginning of another one (or its own: a closed curve) where the
// gap is short and the continuation smooth; shortest and smoothest first.
int BridgeGaps(const std::vector<Edgel>& edgels, const LinkingOptions& options, Chaining* chaining);

// Breaks chains where the end of another chain abuts at an angle.
int BreakAtJunctions(const std::vector<Edgel>& edgels, const LinkingOptions& options,
                     Chaining* chaining);

}  // namespace limn
