// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_cropping.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/tiles/tile_graphs.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::AddLink;
using ::testing::IsEmpty;
using testing::kInfinity;
using testing::LengthOf;
using ::testing::SizeIs;

Eigen::AlignedBox3d HalfSpace() { return testing::SlabBetween(-kInfinity, 0.5); }

Polyline3d Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return testing::Segment(from, to).points;
}

TEST(TileCropping, ALinkThatLeavesEndsExactlyOnTheBorder) {
  DrawingGraph graph;
  AddLink(Line({-1, 0, 0}, {1, 0.3, 0}), false, &graph);
  CropDrawing(HalfSpace(), &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  ASSERT_THAT(graph.links, SizeIs(1));
  const Eigen::Vector3d end = graph.links[0].points_in_world.back();
  EXPECT_EQ(end.x(), 0.5);
  EXPECT_NEAR(end.y(), 0.225, 1e-12);
  EXPECT_TRUE(IsOnBorder(HalfSpace(), end));
  EXPECT_FALSE(IsOnBorder(HalfSpace(), graph.links[0].points_in_world.front()));
}

TEST(TileCropping, WhatIsInsideStaysAndWhatIsOutsideGoes) {
  DrawingGraph graph;
  AddLink(Line({-1, 0, 0}, {0, 0, 0}), false, &graph);
  AddLink(Line({1, 0, 0}, {2, 0, 0}), false, &graph);
  const Polyline3d inside = graph.links[0].points_in_world;
  CropDrawing(HalfSpace(), &graph);
  ASSERT_THAT(graph.links, SizeIs(1));
  EXPECT_EQ(graph.links[0].points_in_world, inside);
  EXPECT_THAT(graph.nodes, SizeIs(2));
}

TEST(TileCropping, AClosedLinkBecomesItsPartsInside) {
  for (const double turn : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    Polyline3d circle;
    for (int i = 0; i < 200; ++i) {
      const double angle = turn + 2 * M_PI * i / 200;
      circle.push_back({0.3 + std::cos(angle), std::sin(angle), 0});
    }
    DrawingGraph graph;
    AddLink(circle, true, &graph);
    // A strip leaves two arcs.
    const Eigen::AlignedBox3d strip(Eigen::Vector3d(0.1, -kInfinity, -1),
                                    Eigen::Vector3d(0.5, kInfinity, 1));
    CropDrawing(strip, &graph);
    EXPECT_THAT(Validate(graph), IsEmpty());
    ASSERT_THAT(graph.links, SizeIs(2));
    for (const DrawingLink& link : graph.links) {
      EXPECT_FALSE(link.closed);
      EXPECT_TRUE(IsOnBorder(strip, link.points_in_world.front()));
      EXPECT_TRUE(IsOnBorder(strip, link.points_in_world.back()));
      EXPECT_NEAR(Length(link.points_in_world), 2 * std::asin(0.2), 1e-3);
    }
  }
}

TEST(TileCropping, PointsOnTheBorderAreCutThereWithoutPiecesOfNoLength) {
  DrawingGraph graph;
  AddLink({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}, false, &graph);
  AddLink({{0.5, 1, 0}, {1, 1, 0}}, false, &graph);               // begins on it and leaves
  AddLink({{0, 2, 0}, {0.5, 2, 0}, {0, 2.5, 0}}, false, &graph);  // touches it
  CropDrawing(HalfSpace(), &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  ASSERT_THAT(graph.links, SizeIs(2));
  EXPECT_NEAR(LengthOf(graph), 0.5 + 0.5 + std::hypot(0.5, 0.5), 1e-12);
}

TEST(TileCropping, JunctionsKeepWhatIsInside) {
  DrawingGraph graph;
  AddLink(Line({-1, 0, 0}, {0, 0, 0}), false, &graph);
  AddLink(Line({0, 0, 0}, {1, 0, 0}), false, &graph);
  AddLink(Line({0, 0, 0}, {0, 1, 0}), false, &graph);
  graph.links[1].node0 = graph.links[2].node0 = graph.links[0].node1;
  graph.nodes[graph.links[0].node1].continuations = {{{0, 1}, {1, 0}}};
  RemoveLinks({1, 1, 1}, &graph);
  CropDrawing(HalfSpace(), &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  EXPECT_THAT(graph.links, SizeIs(3));
  EXPECT_NEAR(LengthOf(graph), 2.5, 1e-9);
  int num_junctions = 0;
  for (const DrawingNode& node : graph.nodes) {
    num_junctions += node.kind == NodeKind::kJunction && node.continuations.size() == 1;
  }
  EXPECT_EQ(num_junctions, 1);
}

TEST(TileCropping, WhatIsInAHoleGoes) {
  DrawingGraph graph;
  AddLink(testing::Segment({-1, 0, 0}, {1, 0, 0}).points, false, &graph);
  AddLink(testing::Segment({-0.1, 0.1, 0}, {0.1, 0.1, 0}).points, false, &graph);
  AddLink(testing::Segment({-1, 2, 0}, {1, 2, 0}).points, false, &graph);
  const Eigen::AlignedBox3d hole(Eigen::Vector3d(-0.25, -1, -1), Eigen::Vector3d(0.5, 1, 1));
  CutOut(hole, &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  ASSERT_EQ(graph.links.size(), 3u);  // both sides of the first, and the last
  EXPECT_NEAR(LengthOf(graph), 0.75 + 0.5 + 2, 1e-9);
  int num_cut = 0;
  for (const DrawingNode& node : graph.nodes) {
    num_cut += IsOnBorder(hole, node.position_in_world);
  }
  EXPECT_EQ(num_cut, 2);
}

}  // namespace
}  // namespace limn
