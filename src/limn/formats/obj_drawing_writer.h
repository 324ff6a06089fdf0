#pragma once

#include <iosfwd>

#include "limn/model/drawing_graph.h"

namespace limn {

// Writes a drawing as Wavefront OBJ: the nodes' vertices first, then per link an object "link_<id>"
// in the group of its kind of edge, where kinds are known, with its inner vertices and one polyline
// element.
void WriteDrawingObj(const DrawingGraph& graph, std::ostream& out);

}  // namespace limn
