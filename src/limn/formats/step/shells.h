// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "limn/model/drawing_graph.h"

namespace limn {

// An edge or face of OpenCASCADE and the link or face of the drawing that it is made from.
struct LabeledShape {
  TopoDS_Shape shape;
  int id = -1;
};

struct StepShells {
  // Solids where shells are closed. All are valid (BRepCheck_Analyzer).
  std::vector<TopoDS_Shape> solids;
  std::vector<TopoDS_Shape> shells;
  std::vector<LabeledShape> faces;
  std::vector<LabeledShape> edges;  // parts of links
  // Faces of the drawing that share no edges with others, as their borders are theirs alone, and
  // those that are in no shell, ascending.
  std::vector<int> apart;
  std::vector<int> left_out;
  // Largest tolerance of an edge or a vertex.
  double tolerance = 0;
};

// The faces of a drawing as shells: a connected set of faces each. Faces that meet share edges. No
// face is made if its border has gaps or leaves its surface by more than 5 % of its size, or if
// OpenCASCADE calls it invalid. Planes are then tried with the points of links in place of their
// primitives, and after that as shells of their own, with the straight border of their triangles.
// Other faces, and planes for which this is not valid either, are left out. Only for the writer of
// STEP files.
StepShells MakeStepShells(const DrawingGraph& graph);

}  // namespace limn
