// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/surfaces/bent_candidate.h"
#include "limn/surfaces/face_links.h"

namespace limn {

// Ruled surfaces that bent links may bound (ours; algorithm/surfaces.md#ruled-faces-and-patches):
// between circles around one axis of the same radius, neighbors along it, as on a cylinder; between
// arcs of which the same holds and whose ends are beside each other; and between any two bent links
// whose ends two straight links join, unless all four lie in a plane. Time: pairs of bent links.
std::vector<BentCandidate> FindRuledCandidates(const std::vector<FaceLink>& links,
                                               const DrawingGraph& graph,
                                               const SurfaceOptions& options);

}  // namespace limn
