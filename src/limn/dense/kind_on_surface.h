// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"

namespace limn {

// Corrects the kind of a link by how it lies on a dense surface (algorithm/kinds.md#dense-data):
// where the surface ends or folds, it is an edge; where it is flat, what looked like an edge is a
// shadow. Outlines of smooth bodies and links behind the surface stay as they are.
void UseSurfaceForKind(DrawingLink* link);

}  // namespace limn
