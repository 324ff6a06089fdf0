// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn::testing {

// How the primitives of a drawing agree with the shapes of true curves, over the links that follow
// one true line, or one true circle, within `tolerance` world units.
struct ShapeAgreement {
  double length_on_lines = 0;  // world units
  double lines_as_lines = 0;   // of it: of links that are lines
  double length_on_circles = 0;
  double circles_as_circles = 0;  // of links that are arcs or circles
  // Of lines longer than `long_line`: angles to the true ones, degrees.
  std::vector<double> direction_errors_deg;
  // Of arcs and circles that turn by more than a radian: |radius / true radius - 1|.
  std::vector<double> radius_errors;
};

// `truth_path` is a file of curves as polylines, which are cut at corners.
ShapeAgreement CompareShapes(const DrawingGraph& graph, const std::string& truth_path,
                             double tolerance, double long_line);

}  // namespace limn::testing
