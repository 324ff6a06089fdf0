#pragma once

#include <set>
#include <vector>

#include "limn/regularity/common_planes.h"
#include "limn/regularity/equal_circles.h"
#include "limn/regularity/parallel_lines.h"

namespace limn {

// Regularities of lines and arcs by index of evidence, local units.
struct RegularityClasses {
  std::vector<DirectionClass> directions;
  std::vector<PlaneClass> planes;
  std::vector<RadiusClass> radii;
  std::vector<AxisClass> axes;
};

// The links that follow any.
std::set<LinkId> MembersOf(const RegularityClasses& classes, const DrawingEvidence& evidence);

// Lets links go, and what too few follow then: directions and circles of fewer than two, planes of
// fewer than three.
void LetGo(const std::set<LinkId>& links, const DrawingEvidence& evidence,
           RegularityClasses* classes);

}  // namespace limn
