// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/alignment/drawing_span.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// A line of the drawing whose direction in the floor plan is known: of a link, or between two
// places.
struct PlanLine {
  DrawingSpan span;
  double angle_rad = 0;  // from x, counter-clockwise seen from above
  std::string text;      // as it was given
};

// From texts such as "link 12 = 30 deg" and "from 3 to 7 = north" (see ParseSpan); instead of an
// angle, x, y, -x, -y, east, north, west or south. Throws OptionError for the option `plan_line`.
std::vector<PlanLine> ParsePlanLines(const std::vector<std::string>& texts);

// The direction of x in the drawing, at right angles to `up`: the mean of what the lines tell,
// weighted by their horizontal lengths. A link may run either way: of both directions the nearer
// one to that of the lines that cannot, or of the first link as it is nearest to `hint` if there
// are none, is meant. Throws OptionError if the drawing has no such link or node, a line is
// upright, or two differ by more than 5 degrees: names them. Preconditions: there are lines, places
// of pixels are known, vectors have unit length.
Eigen::Vector3d FitPlanLines(const DrawingGraph& graph, const std::vector<PlanLine>& lines,
                             const Eigen::Vector3d& up, const Eigen::Vector3d& hint);

}  // namespace limn
