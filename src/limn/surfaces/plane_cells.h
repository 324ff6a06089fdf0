// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/geometry/planar_arrangement.h"
#include "limn/model/faces.h"
#include "limn/surfaces/plane_strokes.h"

namespace limn {

// The strokes of a plane, and the cells between them: candidates for faces.
struct PlaneCells {
  PlaneStrokes strokes;
  PlanarArrangement arrangement;  // of the points of `strokes`
  std::vector<ArrangementCell> cells;
};

// All cells between strokes.
PlaneCells CellsBetween(PlaneStrokes strokes);

// The cells of a plane that are wide enough.
PlaneCells FindPlaneCells(const FacePlane& plane, const std::vector<FaceLink>& links,
                          const DrawingGraph& graph, const SurfaceOptions& options);

// Twice the area over the perimeter.
double WidthOf(const Polygon2d& polygon);

// A face and the cells that it is made of.
struct MadeFace {
  DrawingFace face;
  std::vector<int> cells;
};

// The cells marked 1, as faces: those that only bridges separate become one. Normals are those of
// the plane's frame.
std::vector<MadeFace> MakeFaces(const PlaneCells& plane, const std::vector<uint8_t>& is_face);

// Whether bridges are part of the border of a face.
bool HasBridges(const DrawingFace& face);

}  // namespace limn
