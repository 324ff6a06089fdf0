// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>

#include "limn/formats/step/border_graph.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// The edges of borders as OpenCASCADE's, which share the vertices; only for the writer of STEP
// files. The curve is the primitive of the link, or its points; curves that bound a plane are
// projected onto it, those between planes that are nearly one onto their middle. A straight line,
// also where planes meet at an angle, goes from vertex to vertex; other curves are moved to end at
// the vertices: circles by a third point, in their middle. Tolerances are the distances of vertices
// from ends of curves. Throws Standard_Failure if OpenCASCADE rejects a curve.
std::vector<TopoDS_Edge> MakeBorderEdges(const DrawingGraph& graph, const FaceBorders& borders);

}  // namespace limn
