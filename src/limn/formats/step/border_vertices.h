#pragma once

#include <Eigen/Core>

#include "limn/formats/step/borders.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Where the vertices of borders are; only for the writer of STEP files.

// A position on the points of a link, moved onto its primitive if that is a line or an arc.
Eigen::Vector3d PlaceOnCurve(const DrawingGraph& graph, int link, double position);

// Where links meet; ends without company, and where a closed link begins, are on its curve.
Eigen::Vector3d PlaceOfNode(const DrawingGraph& graph, const DrawingNode& node);

// To the nearest place on all planes of the faces there. Planes at a small angle do not say where
// along them, nor do others if a vertex would move by more than a fifth of its shortest edge. None
// moves by more than this and 10 % of the size of the smallest face.
void FitVerticesToPlanes(const DrawingGraph& graph, FaceBorders* borders);

}  // namespace limn
