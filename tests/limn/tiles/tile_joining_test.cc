// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_joining.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/tiles/tile_graphs.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::AddLink;
using ::testing::IsEmpty;
using testing::kInfinity;
using testing::LengthOf;
using ::testing::SizeIs;
using testing::SlabBetween;

constexpr double kFootprint = 5 / 600.;  // of the views of the origin

class TileJoiningTest : public ::testing::Test {
 protected:
  // The same drawing in tiles cut at these planes, each `offset_px` off its neighbors.
  JoinedTiles Join(const DrawingGraph& graph, const std::vector<double>& planes,
                   double offset_px) const {
    std::vector<TileDrawing> tiles;
    for (size_t i = 0; i + 1 < planes.size(); ++i) {
      tiles.push_back({SlabBetween(planes[i], planes[i + 1]), graph});
      const double offset = (i % 2 ? offset_px : 0) * kFootprint;
      for (DrawingLink& link : tiles.back().graph.links) {
        for (Eigen::Vector3d& point : link.points_in_world) point.y() += offset;
      }
      for (DrawingNode& node : tiles.back().graph.nodes) node.position_in_world.y() += offset;
    }
    JoinedTiles joined = JoinTiles(std::move(tiles), views_);
    EXPECT_THAT(Validate(joined.graph), IsEmpty());
    return joined;
  }

  std::vector<View> views_ = testing::DomeViews(6, 5);
};

TEST_F(TileJoiningTest, ALineThroughManyTilesIsOneLink) {
  DrawingGraph graph;
  AddLink(testing::Segment({-1, 0, 0}, {1, 0.2, 0}).points, false, &graph);
  for (const double offset_px : {0.0, 0.4, 1.5}) {
    SCOPED_TRACE(offset_px);
    const JoinedTiles joined = Join(graph, {-kInfinity, -0.6, -0.1, 0.3, kInfinity}, offset_px);
    EXPECT_EQ(joined.joined, 3);
    EXPECT_EQ(joined.open_ends, 0);
    ASSERT_THAT(joined.graph.links, SizeIs(1));
    EXPECT_THAT(joined.graph.nodes, SizeIs(2));
    EXPECT_NEAR(LengthOf(joined.graph), LengthOf(graph), 0.002);
    const auto& points = joined.graph.links[0].points_in_world;
    for (size_t k = 1; k < points.size(); ++k) {
      const Eigen::Vector3d step = points[k] - points[k - 1];
      EXPECT_GT(step.norm(), 0);
      EXPECT_LT(std::abs(std::atan2(step.y(), step.x()) - std::atan2(0.2, 2)), 0.12);
    }
  }
}

TEST_F(TileJoiningTest, ACircleIsClosedAgain) {
  DrawingGraph graph;
  AddLink(testing::Circle({0, 0, 0}, 0.8).points, true, &graph);
  const JoinedTiles joined = Join(graph, {-kInfinity, -0.5, 0.1, kInfinity}, 0.5);
  EXPECT_EQ(joined.joined, 4);
  ASSERT_THAT(joined.graph.links, SizeIs(1));
  EXPECT_TRUE(joined.graph.links[0].closed);
  EXPECT_NEAR(LengthOf(joined.graph), 1.6 * M_PI, 0.01);
}

TEST_F(TileJoiningTest, WhatTheOtherTileDoesNotHaveEndsAtTheBorder) {
  DrawingGraph with, without;
  AddLink(testing::Segment({-1, 0, 0}, {1, 0, 0}).points, false, &with);
  AddLink(testing::Segment({-1, 0.5, 0}, {1, 0.5, 0}).points, false, &without);
  AddLink(testing::Segment({-0.05, 0.7, 0}, {1, 0.7, 0}).points, false, &with);
  const JoinedTiles joined =
      JoinTiles({{SlabBetween(-kInfinity, 0), with}, {SlabBetween(0, kInfinity), without}}, views_);
  EXPECT_THAT(Validate(joined.graph), IsEmpty());
  EXPECT_EQ(joined.joined, 0);
  EXPECT_EQ(joined.open_ends, 2);
  EXPECT_EQ(joined.stubs, 1);
  EXPECT_THAT(joined.graph.links, SizeIs(2));
}

TEST_F(TileJoiningTest, WhatTurnsAtTheBorderIsAnotherCurve) {
  // They meet at the border; up to 20 degrees is a turn of one curve.
  for (const double degrees : {15.0, 25.0, 80.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * kDeg;
    const Eigen::Vector3d turned(std::cos(angle), std::sin(angle), 0);
    DrawingGraph first, second;
    AddLink(testing::Segment({-1, 0, 0}, {1, 0, 0}).points, false, &first);
    AddLink(testing::Segment(-turned, turned).points, false, &second);
    const JoinedTiles joined = JoinTiles(
        {{SlabBetween(-kInfinity, 0), first}, {SlabBetween(0, kInfinity), second}}, views_);
    EXPECT_THAT(Validate(joined.graph), IsEmpty());
    EXPECT_EQ(joined.joined, degrees < 20 ? 1 : 0);
    EXPECT_EQ(joined.open_ends, degrees < 20 ? 0 : 2);
    EXPECT_THAT(joined.graph.links, SizeIs(degrees < 20 ? 1 : 2));
  }
}

TEST_F(TileJoiningTest, LinesSideBySideKeepApart) {
  DrawingGraph graph;
  for (const double px : {0.0, 4.0, 8.0}) {
    AddLink(testing::Segment({-1, px * kFootprint, 0}, {1, px * kFootprint, 0}).points, false,
            &graph);
  }
  const JoinedTiles joined = Join(graph, {-kInfinity, 0, kInfinity}, 0.5);
  ASSERT_THAT(joined.graph.links, SizeIs(3));
  for (const DrawingLink& link : joined.graph.links) {
    const double across = link.points_in_world.front().y() - link.points_in_world.back().y();
    EXPECT_LT(std::abs(across), kFootprint);
  }
}

TEST_F(TileJoiningTest, ACrossingIsJoinedAlongBothLines) {
  DrawingGraph graph;
  AddLink(testing::Segment({-1, -0.5, 0}, {1, 0.5, 0}).points, false, &graph);
  AddLink(testing::Segment({-1, 0.5, 0}, {1, -0.5, 0}).points, false, &graph);
  const JoinedTiles joined = Join(graph, {-kInfinity, 0, kInfinity}, 0);
  ASSERT_THAT(joined.graph.links, SizeIs(2));
  for (const DrawingLink& link : joined.graph.links) {
    EXPECT_NEAR((link.points_in_world.front() - link.points_in_world.back()).norm(),
                std::hypot(2, 1), 1e-9);
  }
}

// A curve shorter than the gaps that are closed, open at both ends, does not close itself.
TEST_F(TileJoiningTest, WhatIsTinyIsNoLoop) {
  DrawingGraph graph;
  AddLink(testing::Segment({-0.05, 0, 0}, {0.05, 0, 0}).points, false, &graph);
  std::vector<TileDrawing> tiles;
  const double px = kFootprint;
  for (const auto& [low, high] : {std::pair(-px, 0.0), std::pair(0.0, px)}) {
    tiles.push_back({SlabBetween(low, high), graph});
  }
  const JoinedTiles joined = JoinTiles(std::move(tiles), views_);
  EXPECT_THAT(Validate(joined.graph), IsEmpty());
  EXPECT_THAT(joined.graph.links, IsEmpty());
}

TEST_F(TileJoiningTest, ARodIsNotJoinedWithAnOutlineBesideIt) {
  DrawingGraph graph;
  AddLink(testing::Segment({-1, 0, 0}, {1, 0, 0}).points, false, &graph);
  DrawingGraph rod = graph;
  rod.links[0].kind = LinkKind::kRod;
  rod.links[0].rod_radius = 2 * kFootprint;
  const auto join = [&](const DrawingGraph& left, const DrawingGraph& right) {
    return JoinTiles({{SlabBetween(-kInfinity, 0), left}, {SlabBetween(0, kInfinity), right}},
                     views_)
        .joined;
  };
  EXPECT_EQ(join(rod, graph), 0);
  EXPECT_EQ(join(rod, rod), 1);
}

TEST_F(TileJoiningTest, OneTileIsItself) {
  DrawingGraph graph;
  AddLink(testing::Circle({0, 0, 0}, 0.8).points, true, &graph);
  const JoinedTiles joined = Join(graph, {-kInfinity, kInfinity}, 0);
  ASSERT_THAT(joined.graph.links, SizeIs(1));
  EXPECT_EQ(joined.graph.links[0].points_in_world, graph.links[0].points_in_world);
}

TEST_F(TileJoiningTest, AHoleIsFilledByAnotherTile) {
  DrawingGraph old, drawn;
  AddLink(testing::Segment({-1, 0, 0}, {1, 0, 0}).points, false, &old);
  AddLink(testing::Segment({-1, 0.4, 0}, {1, 0.4, 0}).points, false, &old);
  AddLink(testing::Segment({-0.6, 0.4 * kFootprint, 0}, {0.6, 0.4 * kFootprint, 0}).points, false,
          &drawn);
  for (DrawingLink& link : old.links) {
    link.primitive =
        LinkPrimitive{LineSegment{link.points_in_world.front(), link.points_in_world.back()}, 0, 0};
  }
  const Eigen::AlignedBox3d hole(Eigen::Vector3d(-0.3, -0.2, -0.2), Eigen::Vector3d(0.3, 0.2, 0.2));
  const Eigen::AlignedBox3d space = SlabBetween(-kInfinity, kInfinity);
  const JoinedTiles joined = JoinTiles({{space, old, {hole}}, {hole, drawn}}, views_);
  EXPECT_THAT(Validate(joined.graph), IsEmpty());
  EXPECT_EQ(joined.joined, 2);
  EXPECT_EQ(joined.open_ends, 0);
  ASSERT_THAT(joined.graph.links, SizeIs(2));
  EXPECT_NEAR(LengthOf(joined.graph), 4, 0.01);
  int num_untouched = 0;
  for (const DrawingLink& link : joined.graph.links) num_untouched += link.primitive.has_value();
  EXPECT_EQ(num_untouched, 1);
}

}  // namespace
}  // namespace limn
