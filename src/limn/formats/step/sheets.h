// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// A face, or half of one, as a surface that its border alone describes: no surface meets itself.
// Only for the writer of STEP files.
struct StepSheet {
  int face = -1;
  // Loops of a plane; otherwise the sides of one loop.
  std::vector<FaceLoop> sides;
  // Its curves are the points of links.
  bool of_points = false;
};

// The course of an edge with both its ends, on the points of its link or on its bridge.
std::vector<Eigen::Vector3d> CourseOf(const DrawingGraph& graph, const FaceEdge& edge);

// One sheet per face; two for a ruled surface between two closed rails, which is cut along two
// straight lines (bridges): where the first rail begins, and half its length on. On the other rail
// the cuts are at the nearest places, on circles around one axis at the same angles. No sheet for a
// face whose cuts meet there. Time: linear in the points of the borders.
std::vector<StepSheet> SheetsOf(const DrawingGraph& graph);

// A plane between the straight sides of its triangles, as bridges, which it shares with no other
// face. No sides if the triangles have no outline, or not along whole loops. Time n log n in
// triangles.
StepSheet SheetApart(const DrawingGraph& graph, int face_id);

}  // namespace limn
