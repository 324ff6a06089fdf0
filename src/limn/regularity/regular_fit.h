// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "limn/model/drawing_graph.h"
#include "limn/regularity/regularity_classes.h"

namespace limn {

// Lines and arcs after the fit, by index of evidence; the others keep their shapes. Local units.
struct RegularShapes {
  std::map<int, LineSegment> lines;
  std::map<int, CircularArc> arcs;
};

// Fits the lines and arcs that follow regularities, and those that meet them, again, all at once:
// the least squares of the images under the regularities (Ceres; constraints are residuals with a
// large weight, kept to about 1e-4 px). Ends of several links at one node stay together; curves of
// other shapes hold their ends. Updates directions, planes, radii and axes.
RegularShapes FitRegularShapes(const DrawingGraph& graph, const DrawingEvidence& evidence,
                               RegularityClasses* classes);

}  // namespace limn
