#pragma once

#include <vector>

#include "limn/formats/svg/hidden.h"
#include "limn/formats/svg/sheet.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A drawing in parallel projection as one in the plane z = 0, for measuring and editing in CAD: x
// to the right, y up, in the units of the drawing.
struct FlatDrawing {
  // The visible parts of links, with their attributes. Lines, splines, and arcs that are seen from
  // the front keep their shapes; other arcs are polylines. Dimensions keep their places.
  DrawingGraph graph;
  // The true lengths of its dimensions.
  std::vector<double> lengths;
  // What is hidden, if asked for.
  std::vector<Polyline3d> hidden;
};

// Anything shorter than a hundredth of a pixel of the sheet is left out, such as lines seen end on.
// Parts are as in SVG pictures (FindRuns, up to 6 px). Without faces.
FlatDrawing Flatten(const DrawingGraph& graph, const SvgSheet& sheet, const IsHidden& is_hidden,
                    bool with_hidden);

// A place in the coordinates of flat drawings.
Eigen::Vector3d FlatPlace(const SvgSheet& sheet, const Eigen::Vector3d& point_in_world);

}  // namespace limn
