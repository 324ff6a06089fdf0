// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"

namespace limn {

struct StepOptions {
  // Rods as solids of their radius, instead of edges.
  bool rods_as_tubes = false;
};

// What became of faces in a STEP file, as in StepShells, and which rods are edges although tubes
// were asked for, ascending.
struct StepNotes {
  std::vector<int> apart;
  std::vector<int> left_out;
  std::vector<LinkId> rods_left_out;
};

// WriteDrawingStep, for WriteDrawing (write_drawing.h), which does not need OpenCASCADE.
using StepFileWriter = StepNotes (*)(const DrawingGraph& graph, const StepOptions& options,
                                     LengthUnit unit, std::ostream& out);

// Of the library limn::step. Writes a drawing as STEP AP214, an edge-based wireframe in millimeters
// (LengthUnit::kNone is taken for these): a connected edge set "path_<i>" per path (PathsOf), which
// readers turn into a wire, with an edge per link, named by StepNameOf (edges.h): a line, a circle,
// a cubic B-spline, or a B-spline of degree 1 through the points of a link without a primitive.
// Edges that meet at a node share its vertex. Faces are products of their own, "solids" and
// "shells" (step_shells.h), with faces "face_<id>" and edges named like those of links; links that
// bound them are not in the wireframe, but those of faces that are apart or left out are. With
// rods_as_tubes the rods (rods.h) are a product "rods", with solids named like edges of links.
// Throws InputError for a drawing without links, and if OpenCASCADE rejects a curve.
StepNotes WriteDrawingStep(const DrawingGraph& graph, const StepOptions& options, LengthUnit unit,
                           std::ostream& out);

}  // namespace limn
