// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/link_geometry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"
#include "limn/topology/graph_fixture.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::DrawingSceneTest;
using testing::Path;
using testing::Polar;

TEST(TurnBetweenTest, WithoutDirectionNothingContinues) {
  const Vector3d none = Vector3d::Zero();
  for (const Vector3d& direction :
       {Vector3d(1, 0, 0), Vector3d(-0.6, 0.8, 0), Vector3d(0, 0, -1)}) {
    EXPECT_EQ(TurnBetween(none, direction), M_PI / 2);
    EXPECT_EQ(TurnBetween(-direction, none), M_PI / 2);
    LinkTip with, without;
    with.outward = with.bent_outward = direction;
    without.outward = without.bent_outward = none;
    EXPECT_EQ(TurnBetween(with, without), M_PI / 2);
    EXPECT_EQ(TurnBetween(without, with), M_PI / 2);
  }
}

class LinkGeometryTest : public DrawingSceneTest {};

TEST_P(LinkGeometryTest, TipLeavesWhatIsRoundedOut) {
  // The last 1.8 px bend away by 45 degrees.
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, Polar(0.9, 45), Polar(1.8, 45)}));
  const LinkTip tip = scene_.TipAt(Polar(1.8, 45));
  EXPECT_NEAR(tip.outward.dot(Vector3d::UnitX()), 1, 1e-9);
  // The foot of the tip on the line.
  EXPECT_NEAR((tip.point - Vector3d(Polar(1.8, 45).x(), 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(tip.footprint / GetParam().footprint, 1, 1e-9);
}

TEST_P(LinkGeometryTest, TipIsOfTheLastPixelsOnly) {
  // The link bends 15 px before its end: 12 px follow the 2 px of the tip.
  scene_.AddLink(Path({{-15, -40, 0}, {-15, 0, 0}, {0, 0, 0}}));
  const LinkTip tip = scene_.TipAt({0, 0, 0});
  EXPECT_NEAR(tip.outward.dot(Vector3d::UnitX()), 1, 1e-9);
  EXPECT_NEAR(tip.point.norm(), 0, 1e-6);
}

TEST_P(LinkGeometryTest, TipAveragesOverTheseTwelvePixels) {
  // Zigzag by 0.2 px: a direction of the last step alone would be off by 22 degrees.
  auto points = Path({{-40, 0, 0}, {0, 0, 0}});
  for (size_t i = 0; i < points.size(); ++i) points[i].y() += i % 2 ? 0.2 : -0.2;
  scene_.AddLink(points);
  const Vector3d outward = scene_.TipAt(points.back()).outward;
  EXPECT_GT(outward.x(), std::cos(2 * kDeg));
}

TEST_P(LinkGeometryTest, ShortLinkHasATipToo) {
  scene_.AddLink(Path({{0, 0, 0}, {0, 2, 0}}));
  EXPECT_NEAR(scene_.TipAt({0, 2, 0}).outward.dot(Vector3d::UnitY()), 1, 1e-9);
  EXPECT_NEAR(scene_.TipAt({0, 0, 0}).outward.dot(Vector3d::UnitY()), -1, 1e-9);
}

TEST_P(LinkGeometryTest, ArcLengthIsInPixels) {
  scene_.AddLink(Path({{0, 0, 0}, {30, 0, 0}, {30, 10, 0}}));
  const bool backwards = GetParam().even_backwards;
  EXPECT_NEAR(scene_.ArcPxTo({30, 0, 0}), backwards ? 10 : 30, 1e-6);
  EXPECT_NEAR(scene_.ArcPxTo({30, 10, 0}), backwards ? 0 : 40, 1e-6);
}

LIMN_ALL_VARIANTS(LinkGeometryTest);

// Points of the x axis at steps of 1.
Polyline3d Row(int from, int to) {
  Polyline3d points;
  for (int x = from; x <= to; ++x) points.emplace_back(x, 0, 0);
  return points;
}

DrawingLink LinkOf(const Polyline3d& points, double footprint = 1) {
  DrawingLink link = testing::GraphOf({points}).links[0];
  link.vertices.resize(points.size());
  for (LinkVertex& vertex : link.vertices) vertex.footprint = footprint;
  return link;
}

TEST(TipOfTest, StraightLinkLeavesAlongItselfAtItsEnds) {
  const DrawingLink link = LinkOf(Row(0, 30));
  const LinkTip first = TipOf(link, 0, 1);
  EXPECT_LT((first.point - Vector3d(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((first.outward - Vector3d(-1, 0, 0)).norm(), 1e-9);
  const LinkTip last = TipOf(link, 1, 1);
  EXPECT_LT((last.point - Vector3d(30, 0, 0)).norm(), 1e-9);
  EXPECT_LT((last.outward - Vector3d(1, 0, 0)).norm(), 1e-9);
}

TEST(TipOfTest, OutermostPixelsAreLeftOut) {
  Polyline3d hooked = Row(0, 30);
  hooked.emplace_back(30, 1, 0);
  const LinkTip tip = TipOf(LinkOf(hooked), 1, 1);
  EXPECT_LT((tip.outward - Vector3d(1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((tip.point - Vector3d(30, 0, 0)).norm(), 1e-9);
}

TEST(TipOfTest, WhatIsFarFromTheEndDoesNotMatter) {
  Polyline3d bent = {{0, 15, 0}};
  for (const Vector3d& point : Row(0, 15)) bent.push_back(point);
  EXPECT_LT((TipOf(LinkOf(bent), 1, 1).outward - Vector3d(1, 0, 0)).norm(), 1e-9);
  // With pixels twice as large the bend is near.
  EXPECT_GT((TipOf(LinkOf(bent), 1, 2).outward - Vector3d(1, 0, 0)).norm(), 0.1);
}

TEST(TipOfTest, ShortLinkLeavesAlongItsChordAndAPointNowhere) {
  const LinkTip tip = TipOf(LinkOf({{0, 0, 0}, {0.5, 0.5, 0}, {1, 0, 0}}), 0, 1);
  EXPECT_LT((tip.outward - Vector3d(-1, 0, 0)).norm(), 1e-9);
  DrawingLink no_extent;
  no_extent.points_in_world.assign(3, Vector3d(1, 2, 3));
  EXPECT_EQ(TipOf(no_extent, 1, 1).outward, Vector3d(0, 0, 0));
  EXPECT_EQ(TipOf(no_extent, 1, 1).point, Vector3d(1, 2, 3));
}

TEST(TipOfTest, LinkOfFewPointsLeavesAlongItsLastChord) {
  const DrawingLink link = LinkOf({{0, 40, 0}, {0, 0, 0}, {40, 0, 0}});
  EXPECT_LT((TipOf(link, 1, 1).outward - Vector3d(1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((TipOf(link, 0, 1).outward - Vector3d(0, 1, 0)).norm(), 1e-9);
  EXPECT_LT((TipOf(link, 0, 1).point - Vector3d(0, 40, 0)).norm(), 1e-9);
}

TEST(EndPointTest, EndsAreTheFirstAndTheLastPoint) {
  EXPECT_EQ(EndPoint(LinkOf(Row(3, 7)), 0), Vector3d(3, 0, 0));
  EXPECT_EQ(EndPoint(LinkOf(Row(3, 7)), 1), Vector3d(7, 0, 0));
}

TEST(ArcPxTest, EveryStepHasTheFootprintOfItsFirstPoint) {
  DrawingLink link = LinkOf(Row(0, 4), 0.5);
  EXPECT_NEAR(ArcPx(link, 1, 3), 4, 1e-12);
  EXPECT_NEAR(LengthPx(link), 8, 1e-12);
  EXPECT_EQ(ArcPx(link, 2, 2), 0);
  link.vertices[1].footprint = 2;
  EXPECT_NEAR(LengthPx(link), 6.5, 1e-12);
}

TEST(TangentAtTest, RunsFromTheNeighborBeforeToTheOneAfter) {
  const DrawingLink link = LinkOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}});
  EXPECT_LT((TangentAt(link, 0) - Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((TangentAt(link, 1) - Vector3d(1, 1, 0).normalized()).norm(), 1e-12);
  EXPECT_LT((TangentAt(link, 2) - Vector3d(0, 1, 0)).norm(), 1e-12);
  EXPECT_EQ(TangentAt(link, 4), Vector3d(0, 0, 0));
}

TEST(ProbePointsTest, AreEvenlySpreadAndNotTooMany) {
  EXPECT_EQ(ProbePoints(LinkOf(Row(0, 4))), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(ProbePoints(LinkOf(Row(0, 59))).size(), 60u);
  const std::vector<int> every_other = ProbePoints(LinkOf(Row(0, 60)));
  EXPECT_EQ(every_other.size(), 31u);
  EXPECT_EQ(every_other[1], 2);
  EXPECT_EQ(ProbePoints(LinkOf(Row(0, 99))).size(), 50u);
}

TEST(SigmaAcrossTest, IsOfTheInverseInformation) {
  // Known to 0.1 px in y and to 2 px in z, along x.
  EXPECT_NEAR(SigmaAcross(Vector3d(0, 100, 0.25).asDiagonal(), 1), std::sqrt((0.01 + 4) / 2),
              1e-12);
  EXPECT_NEAR(SigmaAcross(Vector3d(0, 1e6, 2500).asDiagonal(), 0.01),
              0.01 * std::sqrt((0.01 + 4) / 2), 1e-12);
}

TEST(SigmaAcrossTest, IsBoundedWhereNothingIsKnown) {
  // 30 px in the direction of which nothing is known.
  EXPECT_NEAR(SigmaAcross(Vector3d(0, 100, 0).asDiagonal(), 1), std::sqrt((0.01 + 900) / 2), 1e-9);
  EXPECT_NEAR(SigmaAcross(Eigen::Matrix3d::Zero(), 0.02), 0.02 * 30, 1e-9);
}

TEST(NumSketchSamplesTest, CountsThoseOfAllVertices) {
  DrawingLink link = LinkOf(Row(0, 2));
  EXPECT_EQ(NumSketchSamples(link), 0);
  link.vertices[0].samples = {{3, 4}, {5, 6}};
  link.vertices[2].samples = {{3, 5}};
  EXPECT_EQ(NumSketchSamples(link), 3);
}

}  // namespace
}  // namespace limn
