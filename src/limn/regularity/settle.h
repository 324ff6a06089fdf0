// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/regularity/apply_shapes.h"
#include "limn/regularity/regularity_classes.h"

namespace limn {

struct SettledRegularities {
  RegularityClasses classes;  // after the fit
  NewShapes shapes;           // that follow them
  std::set<LinkId> let_go;    // no longer follow any
};

// Fits lines and arcs under regularities, and ends memberships until no link's residual in the
// images grows by more than max_growth_px (ours; algorithm/regularity.md#what-leaves). Where links
// resist, what strains a link most by itself goes first; at the end, regularities that would no
// longer strain the result are tried again. Time: a fit per round, about 20.
SettledRegularities SettleRegularities(const DrawingGraph& graph, const DrawingEvidence& evidence,
                                       const RegularityOptions& options, RegularityClasses classes,
                                       const RunContext& context);

}  // namespace limn
