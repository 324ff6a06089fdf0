// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

// Writes the graph of a drawing as undirected GraphML: a node "n<id>" per node with x, y, z, kind
// and degree; an edge "l<id>" per link with link (its id), length (of its points), points (how
// many), primitive ("line", "arc", "circle", "spline", or "polyline" where it has none), views (how
// many support it), residual_px and class (DenseClass, "unknown" before drawing_fuser). Closed
// links are loops, parallel links parallel edges. The graph has the unit if it is known.
void WriteDrawingGraphml(const DrawingGraph& graph, LengthUnit unit, std::ostream& out);

}  // namespace limn
