// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/view.h"
#include "limn/surfaces/face_evidence.h"
#include "limn/surfaces/plane_cells.h"

namespace limn {

// A possible face: a cell of a plane, or a bent surface.
struct CellChoice {
  int plane = -1;  // index of planes, -1: bent
  int cell = -1;   // of the plane's cells
  FaceCandidate candidate;
  FaceEvidence evidence;
};

enum class CellFate : uint8_t {
  kFace,
  kSeenThrough,  // views show what is behind
  kUnseen,       // no views see it and the border around it at once
  kBehind,       // other faces hide it from all views that would see it
  kCopy,         // most of it is on a face of another plane
};

constexpr int kNumCellFates = 5;

// Decides which cells are faces (ours; algorithm/surfaces.md#choice). A cell that views see through
// is not a face. A cell is a face if enough views see most of what they can judge of it, with the
// border around it, enough of its places are seen by enough views, and other faces do not hide it
// from these; besides, if a face is beside it in its plane and only paint, a shadow or a bridge is
// between them. Of faces on top of each other the first stays. Time: views times triangles, squared
// number of cells.
std::vector<CellFate> ChooseCells(const std::vector<View>& views, const DrawingGraph& graph,
                                  const std::vector<PlaneCells>& planes,
                                  const std::vector<CellChoice>& cells,
                                  const SurfaceOptions& options, const RunContext& context);

// Confidence that the surface exists, 0 to 1.
double ConfidenceOf(const CellChoice& choice, const SurfaceOptions& options);

// Views that see at least half of the places that they can judge, or a quarter of those of a bent
// candidate, ascending.
std::vector<ViewId> ViewsOf(const CellChoice& choice);

}  // namespace limn
