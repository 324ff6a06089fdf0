// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/plane_cells.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::FrontalPoint;
using testing::kFrontalPx;

// The cells of the plane with most length; places in px on z = 0.
PlaneCells CellsOf(const DrawingGraph& graph) {
  const std::vector<View> views = testing::FrontalViews(4, 4, 0.3);
  const SurfaceOptions options;
  const auto links = MeasureFaceLinks(graph, views, options);
  const auto planes = FindFacePlanes(links, graph, options, {});
  return planes.empty() ? PlaneCells() : FindPlaneCells(planes[0], links, graph, options);
}

std::vector<double> AreasPx(const PlaneCells& plane) {
  std::vector<double> areas;
  for (const ArrangementCell& cell : plane.cells) {
    areas.push_back(cell.polygon.Area() / (kFrontalPx * kFrontalPx));
  }
  std::ranges::sort(areas);
  return areas;
}

Polyline3d FrontalLine(double x0, double y0, double x1, double y1) {
  return {FrontalPoint(x0, y0), FrontalPoint(x1, y1)};
}

// Three sides of a square of 60 px, and of the left one the part up to `y`.
DrawingGraph OpenSquare(double y) {
  return testing::GraphOf({FrontalLine(0, 0, 60, 0), FrontalLine(60, 0, 60, 60),
                           FrontalLine(60, 60, 0, 60), FrontalLine(0, 0, 0, y)});
}

std::vector<MadeFace> AllFaces(const PlaneCells& plane) {
  return MakeFaces(plane, std::vector<uint8_t>(plane.cells.size(), 1));
}

void ExpectInOrder(const DrawingFace& face, const DrawingGraph& graph) {
  DrawingGraph with_face = graph;
  with_face.faces.push_back(face);
  testing::ExpectValid(with_face);
}

TEST(PlaneCells, ASquareIsACell) {
  const DrawingGraph graph = OpenSquare(60);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 1u);
  EXPECT_NEAR(AreasPx(plane)[0], 3600, 1e-6);
  const std::vector<MadeFace> faces = AllFaces(plane);
  ASSERT_EQ(faces.size(), 1u);
  const DrawingFace& face = faces[0].face;
  ExpectInOrder(face, graph);
  EXPECT_FALSE(HasBridges(face));
  EXPECT_NEAR(AreaOf(face) / (kFrontalPx * kFrontalPx), 3600, 1e-6);
  ASSERT_EQ(face.loops.size(), 1u);
  EXPECT_EQ(face.loops[0].size(), 4u);
  EXPECT_NEAR(std::abs(face.normal.z()), 1, 1e-9);
  EXPECT_NEAR(face.offset, 0, 1e-9);
}

TEST(PlaneCells, MissingPartsAreBridged) {
  // The left side ends before the corner: it goes straight on for its own length.
  const DrawingGraph graph = OpenSquare(40);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 1u);
  EXPECT_NEAR(AreasPx(plane)[0], 3600, 1);
  const DrawingFace face = AllFaces(plane).at(0).face;
  ExpectInOrder(face, graph);
  EXPECT_TRUE(HasBridges(face));
  // Not for more than that.
  EXPECT_TRUE(CellsOf(OpenSquare(25)).cells.empty());
}

TEST(PlaneCells, AMissingCornerIsWhereBothSidesMeet) {
  const DrawingGraph graph =
      testing::GraphOf({FrontalLine(0, 0, 60, 0), FrontalLine(60, 0, 60, 60),
                        FrontalLine(60, 60, 15, 60), FrontalLine(0, 0, 0, 45)});
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 1u);
  EXPECT_NEAR(AreasPx(plane)[0], 3600, 1);
}

TEST(PlaneCells, HolesAreLeftOut) {
  DrawingGraph graph = OpenSquare(60);
  DrawLink({FrontalPoint(20, 20), FrontalPoint(40, 20), FrontalPoint(40, 40), FrontalPoint(20, 40),
            FrontalPoint(20, 20)},
           {}, &graph);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 2u);
  EXPECT_NEAR(AreasPx(plane)[0], 400, 1e-6);
  EXPECT_NEAR(AreasPx(plane)[1], 3200, 1e-6);
  for (const MadeFace& made : AllFaces(plane)) {
    ExpectInOrder(made.face, graph);
    const bool is_frame = AreaOf(made.face) > 1000 * kFrontalPx * kFrontalPx;
    EXPECT_EQ(made.face.loops.size(), is_frame ? 2u : 1u);
  }
  // Only the frame.
  std::vector<uint8_t> is_face;
  for (const ArrangementCell& cell : plane.cells) is_face.push_back(cell.loops.size() == 2);
  const auto frame = MakeFaces(plane, is_face);
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_NEAR(AreaOf(frame[0].face) / (kFrontalPx * kFrontalPx), 3200, 1e-6);
}

TEST(PlaneCells, WhatOnlyABridgeSeparatesIsOne) {
  // A line from the left side to the middle goes on to the right side.
  DrawingGraph graph = OpenSquare(60);
  DrawLink(FrontalLine(3, 30, 40, 30), {}, &graph);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 2u);
  const std::vector<MadeFace> both = AllFaces(plane);
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].cells, (std::vector<int>{0, 1}));
  EXPECT_NEAR(AreaOf(both[0].face) / (kFrontalPx * kFrontalPx), 3600, 1);
  // If only one is a face, the bridge bounds it.
  const std::vector<MadeFace> one = MakeFaces(plane, {1, 0});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(HasBridges(one[0].face));
  EXPECT_NEAR(AreaOf(one[0].face) / (kFrontalPx * kFrontalPx), 1800, 1);
}

TEST(PlaneCells, ALinkAcrossSeparatesFacesAndNarrowCellsAreLeftOut) {
  DrawingGraph graph = OpenSquare(60);
  DrawLink(FrontalLine(-5, 30, 65, 30), {}, &graph);
  EXPECT_EQ(AllFaces(CellsOf(graph)).size(), 2u);
  DrawLink(FrontalLine(-5, 31, 65, 31), {}, &graph);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 2u);
  EXPECT_NEAR(AreasPx(plane)[0], 29 * 60, 1e-6);
  EXPECT_NEAR(AreasPx(plane)[1], 30 * 60, 1e-6);
  // A part of a link, by positions on it.
  bool found = false;
  for (const MadeFace& made : AllFaces(plane)) {
    ExpectInOrder(made.face, graph);
    for (const FaceEdge& edge : made.face.loops[0]) {
      if (edge.link != 4) continue;
      found = true;
      EXPECT_NEAR(std::min(edge.from, edge.to), 5.0 / 70, 1e-9);
      EXPECT_NEAR(std::max(edge.from, edge.to), 65.0 / 70, 1e-9);
    }
  }
  EXPECT_TRUE(found);
}

// The points of a link may be at any distances.
TEST(PlaneCells, PlacesOnLinksAreWhereTheFaceEnds) {
  DrawingGraph graph;
  DrawLink({FrontalPoint(0, 0), FrontalPoint(1, 0), FrontalPoint(3, 0), FrontalPoint(60, 0)}, {},
           &graph);
  DrawLink(FrontalLine(60, 0, 60, 60), {}, &graph);
  DrawLink(FrontalLine(60, 60, 0, 60), {}, &graph);
  DrawLink(FrontalLine(0, 60, 0, 0), {}, &graph);
  DrawLink(FrontalLine(40, 0, 40, 60), {}, &graph);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 2u);
  int num_parts = 0;
  for (const MadeFace& made : AllFaces(plane)) {
    ExpectInOrder(made.face, graph);
    for (const FaceEdge& edge : made.face.loops[0]) {
      if (edge.link != 0) continue;
      ++num_parts;
      const double inner = edge.from > 0 && edge.from < 3 ? edge.from : edge.to;
      EXPECT_NEAR(inner, 2 + 37.0 / 57, 1e-6);
    }
  }
  EXPECT_EQ(num_parts, 2);
}

TEST(PlaneCells, LinksOnTopOfEachOtherCountOnce) {
  DrawingGraph graph = OpenSquare(60);
  DrawLink(FrontalLine(20, 0, 50, 0), {}, &graph);        // on the lower side
  DrawLink(FrontalLine(10, 60.1, 70, 60.1), {}, &graph);  // nearly on the upper one
  DrawLink(FrontalLine(0, 60, 0, 0), {}, &graph);         // back along the left one
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 1u);
  EXPECT_NEAR(AreasPx(plane)[0], 3600, 10);
  for (const MadeFace& made : AllFaces(plane)) ExpectInOrder(made.face, graph);
}

TEST(PlaneCells, HolesThatTouchTheBorderOrEachOther) {
  DrawingGraph graph = OpenSquare(60);
  const auto draw_triangle = [&](double x, double y) {  // its tip at (x, y)
    DrawLink({FrontalPoint(x, y), FrontalPoint(x + 15, y - 5), FrontalPoint(x + 15, y + 5),
              FrontalPoint(x, y)},
             {}, &graph);
  };
  draw_triangle(0, 20);
  draw_triangle(15, 25);
  draw_triangle(20, 45);
  const PlaneCells plane = CellsOf(graph);
  ASSERT_EQ(plane.cells.size(), 4u);
  EXPECT_NEAR(AreasPx(plane).back(), 3600 - 3 * 75, 1e-6);
  double area = 0;
  for (const MadeFace& made : AllFaces(plane)) {
    ExpectInOrder(made.face, graph);
    area += AreaOf(made.face) / (kFrontalPx * kFrontalPx);
  }
  EXPECT_NEAR(area, 3600, 1e-6);
}

}  // namespace
}  // namespace limn
