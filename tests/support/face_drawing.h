// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <vector>

#include "limn/geometry/curve_shape.h"
#include "limn/model/drawing_graph.h"

namespace limn::testing {

// Builds drawings with faces. Shapes that begin or end at the same place share the node there.
class FaceDrawing {
 public:
  LinkId AddShape(const CurveShape& shape);
  LinkId AddLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  // All of a link, or from one position on it to another.
  FaceEdge Whole(LinkId link, bool reversed = false) const;
  static FaceEdge Part(LinkId link, double from, double to);
  static FaceEdge Bridge(std::vector<Eigen::Vector3d> course);
  // Whole links, each turned so that it continues where the one before ends; the first one as it
  // is.
  FaceLoop Loop(const std::vector<LinkId>& links) const;

  // A plane from its outer border, counterclockwise, and its holes, clockwise.
  void AddPlane(const std::vector<FaceLoop>& loops);
  // Between two closed rails, or four sides; the seen side is that of the first rail's direction
  // times the direction to the other rail.
  void AddRuled(const FaceLoop& rail, const FaceLoop& other);
  void AddRuled(const std::vector<FaceLoop>& sides);
  // With one vertex in the middle.
  void AddPatch(const std::vector<FaceLoop>& sides);

  // Points of a loop in order; the last one is the first again.
  std::vector<Eigen::Vector3d> PointsOf(const FaceLoop& loop) const;

  DrawingGraph graph() const;

 private:
  NodeId NodeAt(const Eigen::Vector3d& position);

  DrawingGraph graph_;
};

// 12 lines and 6 squares around [0, 1]^3.
DrawingGraph UnitCube();
// A plate of 3 by 2 in z = 1 with a round hole of radius 0.5; one of its sides is three lines, of
// which the middle one is missing and bridged.
DrawingGraph PlateWithHole();
// Two circles of radius 1 in z = 0 and `top_radius` in z = 2, their caps and the side.
DrawingGraph Cylinder(double top_radius = 1);
// Two half circles of radius 1 in z = 0 and z = 2 and lines between their ends; one face.
DrawingGraph HalfCylinderSide();
// Five arcs that bulge upwards between the corners of a pentagon of radius 2; one face.
DrawingGraph PentagonPatch(double sweep_rad = std::numbers::pi / 2);
// Two squares side by side, over one long line in y = 0, of which each takes a part.
DrawingGraph TwoSquaresOnOneLine();

}  // namespace limn::testing
