// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

// Writes the faces of a drawing as a mesh, binary little-endian PLY: element vertex (double x y z,
// float nx ny nz; faces share none), element face (list uchar int vertex_indices, int face: its id
// in the drawing), triangles counterclockwise seen from the visible side. Throws InputError if
// there are no triangles, or more vertices than an int can count.
void WriteFacesPly(const DrawingGraph& graph, LengthUnit unit, std::ostream& out);

}  // namespace limn
