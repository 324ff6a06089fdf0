// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/surfaces/bent_candidate.h"
#include "limn/surfaces/face_links.h"

namespace limn {

// Patches that loops of links may bound (ours; algorithm/surfaces.md#ruled-faces-and-patches):
// those of FindBentLoops() that go once around their mean normal. Heights over the plane across it
// are mean values of those of the border. Places look at the border as those of flat faces do, in
// that plane.
std::vector<BentCandidate> FindPatchCandidates(const std::vector<FaceLink>& links,
                                               const DrawingGraph& graph,
                                               const SurfaceOptions& options);

}  // namespace limn
