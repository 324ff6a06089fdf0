// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/surfaces/face_candidate.h"
#include "limn/surfaces/plane_cells.h"

namespace limn {

// A cell of a plane as a candidate (ours; algorithm/surfaces.md#evidence): about 24 places on a
// grid, each with the border in 16 directions. A place is judged if links run there in half of
// them.
FaceCandidate FlatCandidate(const PlaneCells& plane, const ArrangementCell& cell);

}  // namespace limn
