// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/surfaces/face_candidate.h"

namespace limn {

// A surface that is not flat.
struct BentCandidate {
  FaceCandidate candidate;
  DrawingFace face;  // its loops, sides and triangles
};

// All of a link as an edge of a face.
inline FaceEdge WholeLink(const DrawingGraph& graph, LinkId link, bool reversed) {
  const double last = graph.links[link].size() - 1;
  return reversed ? FaceEdge{link, last, 0, {}} : FaceEdge{link, 0, last, {}};
}

}  // namespace limn
