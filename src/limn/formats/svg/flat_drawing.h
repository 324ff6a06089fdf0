// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/formats/svg/hidden.h"
#include "limn/formats/svg/sheet.h"
#include "limn/geometry/elliptical_arc.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// What is straight to this on the sheet is drawn as a line: half a thin pen.
constexpr double kStraightMm = 0.1;

// Parts of links in the plane z = 0, with their attributes and numbers.
struct FlatLinks {
  DrawingGraph graph;
  // Per link, if it is one; then it has no primitive.
  std::vector<std::optional<EllipticalArc>> ellipses;
};

// A drawing in parallel projection as one in the plane z = 0, for measuring and editing in CAD: x
// to the right, y up, in the units of the drawing. What is straight to a tenth of a millimeter of
// the sheet is a line; other arcs that are seen from the front, and splines, keep their shapes, and
// arcs seen at an angle are ellipses.
struct FlatDrawing {
  FlatLinks visible;  // with the dimensions, which keep their places
  FlatLinks hidden;   // if asked for
  // The true lengths of the dimensions.
  std::vector<double> lengths;
};

struct FlatOptions {
  bool hidden = false;
  // Lines that are level or plumb within their uncertainty are so exactly (LevelNodes).
  bool regularize = false;
};

// Anything shorter than a hundredth of a pixel of the sheet is left out, such as lines seen end on.
// Parts are as in SVG pictures (FindRuns, up to 6 px). Without faces.
FlatDrawing Flatten(const DrawingGraph& graph, const SvgSheet& sheet, const IsHidden& is_hidden,
                    const FlatOptions& options);

// A place in the coordinates of flat drawings.
Eigen::Vector3d FlatPlace(const SvgSheet& sheet, const Eigen::Vector3d& point_in_world);

}  // namespace limn
