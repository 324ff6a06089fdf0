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
  // Faces of the drawing that are in none, ascending.
  std::vector<int> left_out;
  // Largest tolerance of an edge or a vertex.
  double tolerance = 0;
};

// The faces of a drawing as shells: a connected set of faces each. Faces that meet share edges. A
// face is left out if its border has gaps or leaves its surface by more than 1 % of its size, or if
// OpenCASCADE has no valid face for it. Only for the writer of STEP files.
StepShells MakeStepShells(const DrawingGraph& graph);

}  // namespace limn
