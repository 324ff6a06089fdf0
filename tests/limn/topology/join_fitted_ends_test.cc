// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using testing::FrontalScene;
using testing::PxLine;

// Ends of links that were fitted to the images: see join_facing_ends_test.cc for others.

// Two links on the x axis, the second `gap_px` behind the first and `miss_px` aside; the images
// show nothing.
FrontalScene Facing(double gap_px, double miss_px = 0) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{gap_px, miss_px}, {60, miss_px}});
  return scene;
}

// The same, and the images show a straight line between their ends.
FrontalScene FacingOnAnEdge(double gap_px, double miss_px = 0) {
  FrontalScene scene = Facing(gap_px, miss_px);
  const Eigen::Vector2d gap(gap_px, miss_px);
  scene.Show({-4 * gap.normalized(), gap + 4 * gap.normalized()});
  return scene;
}

void ExpectOneStraightLink(const FrontalScene& scene, double length_px) {
  ASSERT_EQ(scene.graph.links.size(), 1u);
  EXPECT_EQ(scene.graph.nodes.size(), 2u);
  EXPECT_NEAR(scene.LengthPx(0), length_px, 1e-6);
  EXPECT_LT(testing::SharpestTurn(scene.graph.links[0].points_in_world), 1e-6);
}

TEST(JoinFittedEndsTest, SmallGapNeedsNoImages) {
  FrontalScene scene = Facing(2.9);
  EXPECT_EQ(scene.JoinFacing(), 1);
  ExpectOneStraightLink(scene, 120);
  EXPECT_EQ(Facing(3.1).JoinFacing(), 0);
}

TEST(JoinFittedEndsTest, LargerGapNeedsTheImages) {
  FrontalScene scene = FacingOnAnEdge(3.1);
  EXPECT_EQ(scene.JoinFacing(), 1);
  ExpectOneStraightLink(scene, 120);
  FrontalScene wide = FacingOnAnEdge(11.9);
  EXPECT_EQ(wide.JoinFacing(), 1);
  ExpectOneStraightLink(wide, 120);
  EXPECT_EQ(FacingOnAnEdge(12.1).JoinFacing(), 0);
}

TEST(JoinFittedEndsTest, SidesMayMissEachOtherALittle) {
  EXPECT_EQ(Facing(2, 1.4).JoinFacing(), 1);
  EXPECT_EQ(Facing(2, 1.6).JoinFacing(), 0);
  // What the images show does not help.
  EXPECT_EQ(FacingOnAnEdge(10, 1.4).JoinFacing(), 1);
  EXPECT_EQ(FacingOnAnEdge(10, 1.6).JoinFacing(), 0);
}

TEST(JoinFittedEndsTest, OnACurveTheyMayMissByMore) {
  // Two parts of an arc that turns by 0.4 between them: the second begins 2 px beside the line on
  // which the first one ends.
  const double radius = 10 / (2 * std::sin(0.2));
  FrontalScene scene;
  const PxLine arc = testing::ArcFromOrigin(radius, 0.4);
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw(testing::Ray(arc.back(), 0.4, 60));
  PxLine shown = {{-5, 0}};
  shown.insert(shown.end(), arc.begin(), arc.end());
  shown.push_back(arc.back() + 5 * testing::Unit(0.4));
  scene.Show(shown);
  EXPECT_EQ(scene.JoinFacing(), 1);
  // Without a turn it would be too much.
  EXPECT_EQ(FacingOnAnEdge(std::sqrt(96), 2).JoinFacing(), 0);
}

TEST(JoinFittedEndsTest, EndsThatOverlapAreCut) {
  FrontalScene scene = Facing(-2.5);
  EXPECT_EQ(scene.JoinFacing(), 1);
  ExpectOneStraightLink(scene, 120);
}

TEST(JoinFittedEndsTest, EndsThatOverlapTooFarStay) {
  EXPECT_EQ(FacingOnAnEdge(-2.9).JoinFacing(), 1);
  EXPECT_EQ(FacingOnAnEdge(-3.5).JoinFacing(), 0);
}

TEST(JoinFittedEndsTest, EndsTurnLittle) {
  const auto joined = [](double turn_rad) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {0, 0}});
    scene.Draw(testing::Ray(2 * testing::Unit(turn_rad / 2), turn_rad, 60));
    return scene.JoinFacing();
  };
  EXPECT_EQ(joined(0.50), 1);
  EXPECT_EQ(joined(-0.50), 1);
  EXPECT_EQ(joined(0.54), 0);
  EXPECT_EQ(joined(M_PI), 0);  // runs back
}

// With a gap that two ends are on either side of, in the views given.
int64_t JoinedWhereShown(const std::vector<ViewId>& shown, const std::vector<ViewId>& supporting,
                         int min_views) {
  FrontalScene scene;
  scene.options.min_junction_views = min_views;
  scene.Draw({{-60, 0}, {0, 0}}, supporting);
  scene.Draw({{8, 0}, {60, 0}}, supporting);
  scene.Show({{-10, 0}, {20, 0}}, shown);
  return scene.JoinFacing();
}

TEST(JoinFittedEndsTest, EnoughViewsMustShowTheGap) {
  EXPECT_EQ(JoinedWhereShown({0, 1, 2}, {0, 1, 2}, 3), 1);
  EXPECT_EQ(JoinedWhereShown({0, 1}, {0, 1}, 3), 0);
  EXPECT_EQ(JoinedWhereShown({0, 1}, {0, 1}, 2), 1);
  EXPECT_EQ(JoinedWhereShown({0, 1, 2, 3}, {0, 1, 2, 3}, 5), 0);
}

TEST(JoinFittedEndsTest, OnlyViewsThatSupportALinkAreAsked) {
  EXPECT_EQ(JoinedWhereShown({3, 4, 5, 6, 7}, {0, 1, 2}, 3), 0);
}

TEST(JoinFittedEndsTest, NearestEndsFirst) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{2.5, 0.3}, {60, 0.3}});
  scene.Draw(testing::Ray({1, 0}, -0.2, 60));
  EXPECT_EQ(scene.JoinFacing(), 1);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  EXPECT_EQ(scene.Degree(1, 0), 0);
  EXPECT_EQ(scene.Degree(2.5, 0.3), 1);
}

TEST(JoinFittedEndsTest, ChainsInMixedDirectionsAreOneLink) {
  FrontalScene scene;
  scene.Draw({{40, 0}, {22, 0}});
  scene.Draw({{0, 0}, {20, 0}});
  scene.Draw({{60, 0}, {42, 0}});
  scene.Draw({{62, 0}, {80, 0}});
  EXPECT_EQ(scene.JoinFacing(), 3);
  ExpectOneStraightLink(scene, 80);
}

TEST(JoinFittedEndsTest, FarNodesKeepTheirContinuations) {
  FrontalScene scene = Facing(2);
  scene.Draw({{60, 0}, {100, 0}});
  scene.Draw({{60, 0}, {60, 40}});
  const NodeId far = testing::NodeAtPlace(scene.graph, testing::FrontalPoint(60, 0));
  scene.graph.nodes[far].continuations = {{{1, 1}, {2, 0}}};
  EXPECT_EQ(scene.JoinFacing(), 1);
  EXPECT_EQ(scene.Degree(60, 0), 3);
  const auto pairs = testing::ContinuationsAt(scene.graph, testing::FrontalPoint(60, 0));
  ASSERT_EQ(pairs.size(), 1u);
  const auto& [first, second] = *pairs.begin();
  EXPECT_NEAR(scene.LengthPx(first.link), 120, 1e-6);
  EXPECT_NEAR(scene.LengthPx(second.link), 40, 1e-6);
}

// A ring that lacks an arc of this many px; negative: its ends overlap.
FrontalScene OpenRing(double radius_px, double gap_px) {
  FrontalScene scene;
  scene.Draw(testing::ArcFromOrigin(radius_px, 2 * M_PI - gap_px / radius_px));
  return scene;
}

void ExpectClosedRing(const FrontalScene& scene) {
  ASSERT_EQ(scene.graph.links.size(), 1u);
  ASSERT_EQ(scene.graph.nodes.size(), 1u);
  EXPECT_TRUE(scene.graph.links[0].closed);
  EXPECT_EQ(scene.graph.nodes[0].kind, NodeKind::kLoopAnchor);
  EXPECT_EQ(testing::Continuations(scene.graph.nodes[0]).size(), 1u);
  EXPECT_NEAR(scene.LengthPx(0), 120 * M_PI, 1);
}

TEST(JoinFittedEndsTest, RingsAreClosed) {
  FrontalScene scene = OpenRing(60, 2);
  EXPECT_EQ(scene.JoinFacing(), 1);
  ExpectClosedRing(scene);
  EXPECT_LT(testing::SharpestTurn(scene.graph.links[0].points_in_world), 30 * kDeg);
  EXPECT_EQ(OpenRing(60, 8).JoinFacing(), 0);  // no edgels in the gap
}

TEST(JoinFittedEndsTest, RingsWhoseEndsOverlapAreClosed) {
  FrontalScene scene = OpenRing(60, -2);
  EXPECT_EQ(scene.JoinFacing(), 1);
  ExpectClosedRing(scene);
}

TEST(JoinFittedEndsTest, RingsWhoseEndsOverlapDoNotTurnBack) {
  FrontalScene scene = OpenRing(60, -2);
  EXPECT_EQ(scene.JoinFacing(), 1);
  EXPECT_LT(testing::SharpestTurn(scene.graph.links[0].points_in_world), 30 * kDeg);
}

TEST(JoinFittedEndsTest, TwoHalvesOfARingAreClosed) {
  FrontalScene scene;
  const PxLine half = testing::ArcFromOrigin(60, M_PI - 2.0 / 60);
  scene.Draw(half);
  PxLine other;
  for (const Eigen::Vector2d& point : half) other.push_back(Eigen::Vector2d(0, 120) - point);
  scene.Draw(other);
  EXPECT_EQ(scene.JoinFacing(), 2);
  ASSERT_EQ(scene.graph.links.size(), 1u);
  EXPECT_TRUE(scene.graph.links[0].closed);
  EXPECT_NEAR(scene.LengthPx(0), 120 * M_PI, 1);
}

TEST(JoinFittedEndsTest, LoopsAreMuchLongerThanGaps) {
  // A straight link of which each end faces the other, behind it, is none.
  FrontalScene scene;
  scene.Draw({{0, 0}, {2.5, 0}});
  EXPECT_EQ(scene.JoinFacing(), 0);
  EXPECT_FALSE(MayClose(15.9, 0));
  EXPECT_TRUE(MayClose(16, 4));
  EXPECT_FALSE(MayClose(16, 4.1));
  EXPECT_FALSE(MayClose(47, 12));
  EXPECT_TRUE(MayClose(49, 12));
}

TEST(JoinFittedEndsTest, FrozenLinksAreLeftAlone) {
  for (const LinkId frozen : {0, 1}) {
    FrontalScene scene = Facing(2);
    scene.Freeze(frozen);
    const Polyline3d before = scene.graph.links[frozen].points_in_world;
    EXPECT_EQ(scene.JoinFacing(), 0);
    EXPECT_EQ(scene.graph.links.size(), 2u);
    EXPECT_EQ(scene.graph.links[frozen].points_in_world, before);
  }
}

TEST(JoinFittedEndsTest, EndsAtNodesAreNotFree) {
  FrontalScene scene = Facing(2);
  scene.Draw({{0, 0}, {0, 40}});
  EXPECT_EQ(scene.JoinFacing(), 0);
}

}  // namespace
}  // namespace limn
