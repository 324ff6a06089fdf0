// SPDX-License-Identifier: BSD-3-Clause
// Sheets of drawings with faces: hidden lines, flat drawings, sections and dimensions.
#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/picture_scene.h"
#include "limn/formats/svg/svg_drawing_writer.h"
#include "limn/plans/face_axes.h"
#include "limn/visibility/face_surface.h"
#include "limn/visibility/render_depth.h"
#include "support/face_drawing.h"

namespace limn {
namespace {

using ::testing::HasSubstr;

SvgSheet SheetOf(const DrawingGraph& graph, SvgProjection projection) {
  SheetOptions options;
  options.projection = projection;
  return MakeSheet(graph, options);
}

IsHidden HiddenByFaces(const DrawingGraph& graph, const SvgSheet& sheet) {
  return HiddenOnSheet(RenderOrthographicDepth(MeshOf(graph.faces), DepthFrame(sheet)));
}

TEST(PlanFiles, ACubeFromTheFrontAndAboveShowsNineEdges) {
  const DrawingGraph cube = testing::UnitCube();
  const SvgSheet sheet = SheetOf(cube, SvgProjection::kAxonometric);
  const FlatDrawing flat = Flatten(cube, sheet, HiddenByFaces(cube, sheet), {true, false});
  EXPECT_EQ(flat.visible.graph.links.size(), 9u);
  EXPECT_EQ(flat.hidden.graph.links.size(), 3u);
  EXPECT_THAT(Validate(flat.visible.graph), ::testing::IsEmpty());
  EXPECT_THAT(Validate(flat.hidden.graph), ::testing::IsEmpty());
  double hidden = 0, visible = 0;
  for (const DrawingLink& link : flat.hidden.graph.links) {
    EXPECT_STREQ(ShapeName(link.primitive->shape), "line");
    hidden += Length(link.points_in_world);
  }
  for (const DrawingLink& link : flat.visible.graph.links) {
    visible += Length(link.points_in_world);
    for (const Eigen::Vector3d& point : link.points_in_world) EXPECT_EQ(point.z(), 0);
  }
  // Isometric: all edges are shortened alike; borders are a few pixels off.
  EXPECT_NEAR(visible, 9 * std::sqrt(2.0 / 3), 0.02);
  EXPECT_NEAR(hidden, 3 * std::sqrt(2.0 / 3), 0.02);
  EXPECT_TRUE(Flatten(cube, sheet, HiddenByFaces(cube, sheet), {}).hidden.graph.links.empty());
}

TEST(PlanFiles, InAPhotographToo) {
  const DrawingGraph cube = testing::UnitCube();
  View view;
  view.name = "a.png";
  view.camera = {500, 500, 320, 240, 640, 480};
  // From the front, the right and above.
  const Eigen::Vector3d center(3, -4, 3.5), target(0.5, 0.5, 0.5);
  const Eigen::Vector3d forward = (target - center).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  view.cam_from_world = {Eigen::Quaterniond(rotation), -rotation * center};
  view.region = MakeImageRegion(view.camera, nullptr, {}, 0);
  const IsHidden is_hidden = HiddenInView(view, RenderDepth(MeshOf(cube.faces), view, /*scale=*/1));
  std::ostringstream out;
  const SvgSummary summary = WriteDrawingSvg(cube, view, is_hidden, {}, out);
  EXPECT_EQ(summary.num_drawn, 9);
  EXPECT_EQ(summary.num_hidden, 3);
}

TEST(PlanFiles, ASheetAlongAFaceIsToScale) {
  DrawingGraph cube = testing::UnitCube();
  AddLink({{0.3, 0.5, 0.3}, {0.7, 0.5, 0.3}}, std::nullopt, &cube);  // inside
  RebuildIncidence(&cube);
  SheetOptions options;
  options.axes = AxesAlong(cube.faces[2], Eigen::Vector3d(0, 0, 1));
  const SvgSheet sheet = MakeSheet(cube, options);
  EXPECT_EQ(sheet.ToSheet({0.25, 0.5, 0.75}), Eigen::Vector2d(0.25, -0.75));
  const FlatDrawing flat = Flatten(cube, sheet, HiddenByFaces(cube, sheet), {});
  // The edges behind are on the outline, those towards the viewer have no length.
  EXPECT_EQ(flat.visible.graph.links.size(), 8u);
  for (const DrawingLink& link : flat.visible.graph.links) {
    EXPECT_NEAR(Length(link.points_in_world), 1, 0.01);
    EXPECT_STREQ(ShapeName(link.primitive->shape), "line");
  }
}

TEST(PlanFiles, ArcsSeenFromTheFrontStayArcs) {
  const DrawingGraph cylinder = testing::Cylinder();
  const FlatDrawing top = Flatten(cylinder, SheetOf(cylinder, SvgProjection::kTop), {}, {});
  ASSERT_EQ(top.visible.graph.links.size(), 2u);
  for (const DrawingLink& link : top.visible.graph.links) {
    ASSERT_TRUE(link.primitive);
    EXPECT_EQ(std::get<CircularArc>(link.primitive->shape).radius, 1);
    EXPECT_EQ(ValidateShape(link.primitive->shape), "");
    EXPECT_TRUE(link.closed);
  }
  const FlatDrawing aslant =
      Flatten(cylinder, SheetOf(cylinder, SvgProjection::kAxonometric), {}, {});
  ASSERT_EQ(aslant.visible.graph.links.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_FALSE(aslant.visible.graph.links[i].primitive);
    const auto& ellipse = aslant.visible.ellipses[i];
    ASSERT_TRUE(ellipse);
    EXPECT_NEAR(ellipse->major.norm(), 1, 1e-9);
    EXPECT_NEAR(ellipse->Ratio(), std::sqrt(1.0 / 3), 1e-9);  // isometric
    EXPECT_NEAR(ellipse->end_rad - ellipse->begin_rad, 2 * std::numbers::pi, 1e-9);
  }
}

TEST(PlanFiles, WhatIsStraightOnTheSheetIsALine) {
  DrawingGraph graph;
  // Edge-on, and an arc of 0.05 mm on A3.
  CircularArc arc;
  arc.radius = 1;
  arc.sweep_rad = 1;
  arc.y_axis = Eigen::Vector3d::UnitZ();
  AddLink(SampleShape(arc, 1e-4), arc, &graph);
  CircularArc flat_arc;
  flat_arc.center = {-1000, 0.5, 0};
  flat_arc.radius = 1000;
  flat_arc.sweep_rad = 0.001;
  AddLink(SampleShape(flat_arc, 1e-4), flat_arc, &graph);
  RebuildIncidence(&graph);
  const FlatDrawing flat = Flatten(graph, SheetOf(graph, SvgProjection::kTop), {}, {});
  ASSERT_EQ(flat.visible.graph.links.size(), 2u);
  for (const DrawingLink& link : flat.visible.graph.links) {
    ASSERT_TRUE(link.primitive);
    EXPECT_STREQ(ShapeName(link.primitive->shape), "line");
  }
}

// A rectangle whose corners are a little off, within their uncertainty, and a diagonal.
TEST(PlanFiles, LinesAreLevelAndPlumbWhereTheyMayBe) {
  DrawingGraph graph;
  const Eigen::Vector3d a(0, 0, 0), b(4, 0, 0.01), c(4.01, 0, 3), d(0, 0, 2.99), e(2, 0, 1);
  for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, d}, {d, a}, {a, e}}) {
    AddLink({from, to}, LineSegment{from, to}, &graph);
  }
  RebuildIncidence(&graph);
  const auto shape_of = [](const FlatDrawing& flat, int link) {
    const auto& line = std::get<LineSegment>(flat.visible.graph.links[link].primitive->shape);
    return Eigen::Vector3d((line.end - line.start).cwiseAbs());
  };
  const SvgSheet sheet = SheetOf(graph, SvgProjection::kFront);
  const auto set_sigma = [&](double sigma) {
    for (DrawingNode& node : graph.nodes) {
      node.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
    }
  };
  set_sigma(0.01);
  const FlatDrawing flat = Flatten(graph, sheet, {}, {false, true});
  ASSERT_EQ(flat.visible.graph.links.size(), 5u);
  for (const int level : {0, 2}) EXPECT_EQ(shape_of(flat, level).y(), 0);
  for (const int plumb : {1, 3}) EXPECT_EQ(shape_of(flat, plumb).x(), 0);
  EXPECT_GT(shape_of(flat, 4).head<2>().minCoeff(), 0.9);
  EXPECT_NEAR(shape_of(flat, 0).x(), 4.005, 1e-9);
  EXPECT_THAT(Validate(flat.visible.graph), ::testing::IsEmpty());
  EXPECT_NEAR(shape_of(Flatten(graph, sheet, {}, {}), 0).y(), 0.01, 1e-12);
  set_sigma(0.001);  // they are off indeed
  EXPECT_NEAR(shape_of(Flatten(graph, sheet, {}, {false, true}), 0).y(), 0.01, 1e-12);
}

TEST(PlanFiles, DimensionsAreSeenInTheirTrueLength) {
  DrawingGraph cube = testing::UnitCube();
  cube.dimensions = {{{0, 0, 0}, {1, 1, 0}, {0.1, -0.1, 0}}, {{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  const SvgSheet sheet = SheetOf(cube, SvgProjection::kFront);
  const FlatDrawing flat = Flatten(cube, sheet, {}, {});
  // The second one runs towards the viewer.
  ASSERT_EQ(flat.visible.graph.dimensions.size(), 1u);
  EXPECT_NEAR(flat.lengths[0], std::sqrt(2), 1e-12);
  EXPECT_LT((flat.visible.graph.dimensions[0].to - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  SvgOptions options;
  options.dimension_text.unit = LengthUnit::kMeter;
  std::ostringstream out;
  WriteDrawingSvg(cube, sheet, {}, options, out);
  EXPECT_THAT(out.str(), HasSubstr("id=\"dimension_0\""));
  EXPECT_THAT(out.str(), HasSubstr(">1.414 m</text>"));
  EXPECT_EQ(out.str().find("id=\"dimension_1\""), std::string::npos);
}

TEST(PlanFiles, TextsOfDimensions) {
  EXPECT_EQ((DimensionText{1, LengthUnit::kMeter}).Of(2.4), "2.4 m");
  EXPECT_EQ((DimensionText{1, LengthUnit::kMillimeter}).Of(0.26), "0.3 mm");
  EXPECT_EQ((DimensionText{2, LengthUnit::kFoot}).Of(1.00049), "2.001 ft");
  EXPECT_EQ((DimensionText{1, LengthUnit::kMeter}).Of(2.4, 0.0034), "2.4 \u00b1 0.003 m");
  EXPECT_EQ((DimensionText{1, LengthUnit::kMeter}).Of(2.4, 0.0001), "2.4 m");
  EXPECT_EQ((DimensionText{}).Of(123.456), "123.5");
  EXPECT_EQ((DimensionText{}).Of(0.00123456), "0.001235");
}

TEST(PlanFiles, DimensionLinesAreBesideThePlaces) {
  const DimensionLines lines = LinesOf({{0, 0, 0}, {2, 0, 0}, {0.5, 0, 1}});
  EXPECT_EQ(lines.from, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(lines.to, Eigen::Vector3d(2, 0, 1));
  EXPECT_EQ(lines.aside, Eigen::Vector3d(0, 0, 1));
  const DimensionLines upright = LinesOf({{0, 0, 0}, {0, 0, 2}, {0, 0, 0}});
  EXPECT_NEAR(upright.aside.dot(upright.along), 0, 1e-12);
  EXPECT_NEAR(upright.aside.norm(), 1, 1e-12);
}

TEST(PlanFiles, SectionsAreThickLines) {
  const DrawingGraph cube = testing::UnitCube();
  SvgOptions options;
  options.section = CutAt(0.5, cube.faces, cube.links, 0);
  std::ostringstream out;
  WriteDrawingSvg(cube, SheetOf(cube, SvgProjection::kTop), {}, options, out);
  const std::regex line("<path class=\"closed\" d=\"[^\"]*z\"/>");
  EXPECT_TRUE(std::regex_search(out.str(), line));
  EXPECT_THAT(out.str(), HasSubstr("#section{"));
}

}  // namespace
}  // namespace limn
