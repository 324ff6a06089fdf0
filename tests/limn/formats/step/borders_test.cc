// SPDX-License-Identifier: BSD-3-Clause
// Faces of drawings from photographs in STEP files: borders that fit planes and primitives badly
// are still shared.
#include "limn/formats/step/borders.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/step/sheets.h"
#include "limn/formats/step/step_read_back.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using StepBorders = StepFaces;
using testing::FaceDrawing;

void SetPlane(const Eigen::Vector3d& normal, double offset, DrawingFace* face) {
  face->normal = normal.normalized();
  face->offset = offset / normal.norm();
}

// Two rectangles of 1 by `width` in z = 0, on both sides of a shared curve from the origin along x.
FaceDrawing TwoRectangles(const CurveShape& shared, double width) {
  FaceDrawing drawing;
  const Eigen::Vector3d origin(0, 0, 0), end(1, 0, 0);
  const LinkId middle = drawing.AddShape(shared);
  for (const double side : {-width, width}) {
    const Eigen::Vector3d out(0, side, 0);
    const LinkId right = drawing.AddLine(end, end + out);
    const LinkId far = drawing.AddLine(end + out, out);
    const LinkId left = drawing.AddLine(out, origin);
    drawing.AddPlane({drawing.Loop({middle, right, far, left})});
  }
  return drawing;
}

// From the origin to (1, 0, 0), bulging along y.
CircularArc ArcAlongX(double bulge) {
  CircularArc arc;
  arc.radius = (bulge * bulge + 0.25) / (2 * bulge);
  arc.center = {0.5, bulge - arc.radius, 0};
  arc.x_axis = (Eigen::Vector3d(0, 0, 0) - arc.center).normalized();
  arc.y_axis = Eigen::Vector3d(arc.x_axis.y(), -arc.x_axis.x(), 0);
  arc.sweep_rad = 2 * std::asin(0.5 / arc.radius);
  return arc;
}

TEST_F(StepBorders, PrimitivesMayEndBeforeTheirLinks) {
  FaceDrawing drawing;
  const LinkId base = drawing.AddLine({0, 0, 0}, {1, 0, 0});
  const LinkId right = drawing.AddLine({1, 0.03, 0}, {1, 1, 0});
  const LinkId top = drawing.AddLine({1, 1, 0}, {0, 1, 0});
  const LinkId left = drawing.AddLine({0, 1, 0}, {0, 0, 0});
  drawing.AddPlane({{drawing.Whole(base), FaceDrawing::Bridge({{1, 0, 0}, {1, 0.03, 0}}),
                     drawing.Whole(right), drawing.Whole(top), drawing.Whole(left)}});
  const LinkId below = drawing.AddLine({0, 0, 0}, {0, 0, 1});
  const LinkId across = drawing.AddLine({0, 0, 1}, {1, 0, 0.03});
  drawing.AddPlane({{drawing.Whole(base), FaceDrawing::Bridge({{1, 0, 0}, {1, 0, 0.03}}),
                     drawing.Whole(across, true), drawing.Whole(below, true)}});
  DrawingGraph graph = drawing.graph();
  std::get<LineSegment>(graph.links[base].primitive->shape).end.x() = 0.9;
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_NEAR(AreaOfShape(read), 1.5, 0.02);
}

// The short bridge would not let its ends go to the plane.
TEST_F(StepBorders, ShortEdgesAreProjectedOntoTheirPlane) {
  FaceDrawing drawing;
  const Eigen::Vector3d corner(1, 0, 0.06), beside(1, 0.04, 0.06);
  const LinkId base = drawing.AddLine({0, 0, 0}, corner);
  const LinkId right = drawing.AddLine(beside, {1, 1, 0});
  const LinkId top = drawing.AddLine({1, 1, 0}, {0, 1, 0});
  const LinkId left = drawing.AddLine({0, 1, 0}, {0, 0, 0});
  drawing.AddPlane({{drawing.Whole(base), FaceDrawing::Bridge({corner, beside}),
                     drawing.Whole(right), drawing.Whole(top), drawing.Whole(left)}});
  DrawingGraph graph = drawing.graph();
  SetPlane(Eigen::Vector3d::UnitZ(), 0, &graph.faces[0]);
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_NEAR(AreaOfShape(read), 1, 1e-6);
  EXPECT_LT(LargestToleranceOf(read), 1e-5);
}

// Their line of intersection is far from the link.
TEST_F(StepBorders, PlanesThatAreNearlyOneShareTheEdgeBetweenThem) {
  DrawingGraph graph = TwoRectangles(ArcAlongX(0.1), 1).graph();
  SetPlane({0.05, 0, 1}, 0.05, &graph.faces[0]);
  SetPlane({-0.05, 0, 1}, -0.05, &graph.faces[1]);
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 7u);
  EXPECT_LT(LargestToleranceOf(read), 0.05 * 1.5);
}

// The arc bulges more than its points, over the far side of one of the rectangles.
TEST_F(StepBorders, CurvesThatCrossTheBorderGiveWayToPoints) {
  DrawingGraph graph = TwoRectangles(ArcAlongX(0.02), 0.1).graph();
  graph.links[0].primitive->shape = ArcAlongX(0.15);
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  EXPECT_EQ(SubShapes(read, TopAbs_SHELL).size(), 1u);
  EXPECT_EQ(SubShapes(read, TopAbs_EDGE).size(), 7u);
  EXPECT_NEAR(AreaOfShape(read), 0.2, 1e-6);
}

TEST_F(StepBorders, AHoleThatTouchesTheBorderIsALoopOfItsOwn) {
  FaceDrawing drawing;
  const std::vector<Eigen::Vector3d> corners = {{1, 0, 0},     {1, 1, 0},   {0, 1, 0},
                                                {0, 0, 0},     {0.5, 0, 0}, {0.3, 0.6, 0},
                                                {0.7, 0.6, 0}, {0.5, 0, 0}};
  std::vector<LinkId> links;
  for (size_t k = 0; k < corners.size(); ++k) {
    links.push_back(drawing.AddLine(corners[k], corners[(k + 1) % corners.size()]));
  }
  drawing.AddPlane({drawing.Loop(links)});
  const DrawingGraph graph = drawing.graph();
  const FaceBorders borders = MakeFaceBorders(graph, SheetsOf(graph), 0.05);
  ASSERT_EQ(borders.sheets.size(), 1u);
  ASSERT_EQ(borders.sheets[0].sides.size(), 2u);
  EXPECT_EQ(borders.sheets[0].sides[0].size(), 5u);
  EXPECT_EQ(borders.sheets[0].sides[1].size(), 3u);
  const TopoDS_Shape read = ReadBack(graph);
  EXPECT_THAT(left_out_, ::testing::IsEmpty());
  const std::vector<TopoDS_Shape> faces = SubShapes(read, TopAbs_FACE);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(SubShapes(faces[0], TopAbs_WIRE).size(), 2u);
  EXPECT_EQ(SubShapes(read, TopAbs_VERTEX).size(), 7u);
  EXPECT_NEAR(AreaOfShape(read), 1 - 0.12, 1e-6);
}

}  // namespace
}  // namespace limn
