// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/curves_scene.h"
#include "limn/model/scene_hints.h"
#include "limn/support/edgel_index.h"
#include "limn/surfaces/face_candidate.h"
#include "limn/surfaces/surface_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Whether a view sees a place of a candidate.
enum class PlaceSight : uint8_t {
  kUnknown,  // too little of the place and its border is in the image
  kHidden,
  kSeen,
};

// Per view, the places of a candidate.
using PlaceSights = std::map<ViewId, std::vector<PlaceSight>>;

struct FaceEvidence {
  // From curves and points seen behind it: the logarithm of how much likelier that is if the
  // surface exists; negative.
  double seen_through = 0;
  // The same from what is hidden behind it; positive.
  double hidden = 0;
  PlaceSights sights;  // without views that see none
};

// What the images say about the candidates (ours; algorithm/surfaces.md#evidence). The supporting
// views of links are ids of the scene's views. Within the gate, the refinement's, an edgel shows a
// link.
//
// Occlusion: a view that shows a curve behind a surface looks through it; if it shows the curve
// elsewhere but not behind the surface, the curve is hidden there. Points of the model seen through
// the surface count as curves do.
//
// Borders: a view sees a place of a surface only if it sees most of the border around the place. Of
// a disc inside a solid, each view shows the half of the border on its own side only.
//
// The result does not depend on the number of threads. Time: views times (samples of links plus
// candidates times links and points whose images overlap).
std::vector<FaceEvidence> FindFaceEvidence(const CurvesScene& scene, const SupportGate& gate,
                                           const DrawingGraph& graph,
                                           const std::vector<FaceCandidate>& candidates,
                                           const SurfaceOptions& options,
                                           const RunContext& context);

}  // namespace limn
