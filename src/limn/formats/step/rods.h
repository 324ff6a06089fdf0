// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/formats/step/shells.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Rods as solids; only for step_drawing_writer.cc.
struct StepRods {
  // The solid and its link; all are valid (BRepCheck_Analyzer).
  std::vector<LabeledShape> tubes;
  // Rods without one, ascending.
  std::vector<LinkId> left_out;
  // Largest tolerance of an edge or a vertex, mm.
  double tolerance = 0;
};

// Sweeps a disk along the primitive of each rod: cylinders along lines, tori along arcs, B-spline
// surfaces along splines, exact but for the last; with flat ends unless the rod is closed. A rod
// has no solid without a primitive, or where it is bent more than its thickness allows, or if
// OpenCASCADE makes no valid one. Coordinates in millimeters.
StepRods MakeStepRods(const DrawingGraph& graph);

}  // namespace limn
