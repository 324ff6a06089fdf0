#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/view.h"
#include "limn/surfaces/face_evidence.h"

namespace limn {

// A cell of a plane as a possible face.
struct CellChoice {
  size_t plane = 0;
  int cell = -1;  // of the plane's cells
  FaceCandidate candidate;
  FaceEvidence evidence;
};

enum class CellFate : uint8_t {
  kFace,
  kSeenThrough,  // views show what is behind
  kUnseen,       // no views see it and the border around it at once
  kBehind,       // other faces hide it from all views that would see it
};

// Which cells are faces (ours; ALGORITHM.md 27.4). What views see through is none. A cell is a face
// if enough views see it whole, with the border around it, and other faces do not hide it from
// these views; besides, if a face is beside it in its plane and only paint, a shadow or a bridge is
// between them. Time: views times triangles.
std::vector<CellFate> ChooseCells(const std::vector<View>& views, const DrawingGraph& graph,
                                  const std::vector<PlaneCells>& planes,
                                  const std::vector<CellChoice>& cells,
                                  const SurfaceOptions& options, const RunContext& context);

// How sure it is that there is a surface, 0 to 1.
double ConfidenceOf(const FaceEvidence& evidence, const SurfaceOptions& options);

// Views that see at least half of the places, ascending.
std::vector<ViewId> ViewsOf(const FaceEvidence& evidence);

}  // namespace limn
