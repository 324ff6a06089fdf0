// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

// Writes a drawing as binary little-endian PLY: element vertex (double x y z, uchar red green blue,
// double sigma), links share the vertices at their nodes; element edge (int vertex1 vertex2, uchar
// red green blue, int link; uchar class and uchar kind where known). One color per curve, white at
// nodes. No vertex property is an integer wider than uchar, so that COLMAP's PLY importer accepts
// the file. A comment tells the unit if it is known.
void WriteDrawingPly(const DrawingGraph& graph, LengthUnit unit, std::ostream& out);

}  // namespace limn
