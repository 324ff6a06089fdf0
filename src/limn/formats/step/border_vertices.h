// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/formats/step/border_graph.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Where the vertices of borders are; only for the writer of STEP files.

// A position on the points of a link, moved onto its primitive if that is a line or an arc.
Eigen::Vector3d PlaceOnCurve(const DrawingGraph& graph, int link, double position);

// The position of a node where links meet; a single end, and the start of a closed link, is on its
// curve.
Eigen::Vector3d PlaceOfNode(const DrawingGraph& graph, const DrawingNode& node);

// Moves vertices to the nearest place on all planes of the faces there. Planes at a small angle do
// not determine a place along their intersection, and others are ignored if a vertex would move by
// more than a fifth of its shortest edge. No vertex moves by more than that and 10 % of the size of
// the smallest face.
void FitVerticesToPlanes(const DrawingGraph& graph, FaceBorders* borders);

}  // namespace limn
