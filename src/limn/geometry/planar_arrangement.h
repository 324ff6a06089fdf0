// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/geometry/polygon2d.h"

namespace limn {

// A part of a stroke: `from` and `to` are the index of a point plus a fraction; from > to runs
// against the stroke's direction.
struct StrokeRun {
  int stroke = -1;
  double from = 0;
  double to = 0;
};

// A straight edge between two vertices, a part of a stroke.
struct ArrangementEdge {
  int a = -1;
  int b = -1;
  StrokeRun run;
};

// The planar graph of strokes that are cut where they meet.
struct PlanarArrangement {
  std::vector<Eigen::Vector2d> vertices;
  // No two between the same vertices.
  std::vector<ArrangementEdge> edges;
};

// Edge 2 * e runs along edge e, 2 * e + 1 back.
using HalfEdge = int;

// A region that edges surround.
struct ArrangementCell {
  // Outer border first, counterclockwise, then holes, clockwise: the cell is on the left of all.
  std::vector<std::vector<HalfEdge>> loops;
  Polygon2d polygon;  // the same loops
};

// Cuts strokes where they cross or touch each other, and where they cross themselves. Points nearer
// than `tolerance` > 0 become one vertex, and where strokes coincide the first has the edge.
// Strokes have at least two points. Time: pairs of segments that overlap in x.
PlanarArrangement Arrange(const std::vector<Polyline2d>& strokes, double tolerance);

// The cells between the edges marked 1; edges that bound none, on both sides the same, are left
// out. Time n log n, holes times cells.
std::vector<ArrangementCell> FindCells(const PlanarArrangement& arrangement,
                                       std::vector<uint8_t> use_edge);

// The runs of strokes along a loop: consecutive edges of a stroke are one run. Begins at a change
// of stroke if there is one.
std::vector<StrokeRun> RunsAlong(const PlanarArrangement& arrangement,
                                 const std::vector<HalfEdge>& loop);

}  // namespace limn
