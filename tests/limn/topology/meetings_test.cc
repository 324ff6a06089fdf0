// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/meetings.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::FrontalPoint;
using testing::FrontalScene;

TEST(ReachTest, IsThatOfTheOptions) {
  TopologyOptions options;
  options.max_junction_gap_px = 20;
  options.max_junction_miss_px = 8;
  const Reach drawn = Reach::Drawn(options);
  EXPECT_EQ(drawn.gap_px, 20);
  EXPECT_EQ(drawn.overshoot_px, 10);
  EXPECT_EQ(drawn.miss_px, 8);
  // Fitted links get smaller limits, except for the gap.
  const Reach fitted = Reach::Fitted(options);
  EXPECT_EQ(fitted.gap_px, 20);
  EXPECT_EQ(fitted.overshoot_px, 5);
  EXPECT_EQ(fitted.miss_px, 3);
}

// From a tip at (10, 0, 0) that points along x; a px is 2.
std::optional<Reach::Offset> Offset(double x_px, double y_px, double turn_rad = 0) {
  const LinkTip tip = {{10, 0, 0}, {1, 0, 0}, 2};
  return Reach{12, 6, 4}.To(tip, Vector3d(10 + 2 * x_px, 0, 2 * y_px), turn_rad);
}

TEST(ReachTest, PlacesAreAheadOrALittleBehind) {
  EXPECT_TRUE(Offset(11.9, 0));
  EXPECT_FALSE(Offset(12.1, 0));
  EXPECT_TRUE(Offset(-5.9, 0));
  EXPECT_FALSE(Offset(-6.1, 0));
  EXPECT_TRUE(Offset(3, 3.9));
  EXPECT_FALSE(Offset(3, -4.1));
  EXPECT_NEAR(Offset(-3, -2)->along_px, -3, 1e-12);
  EXPECT_NEAR(Offset(-3, -2)->miss_px, 2, 1e-12);
}

TEST(ReachTest, CurvesThatTurnMayMissByMore) {
  // Half of the turn over the way.
  EXPECT_TRUE(Offset(10, 5.9, 0.4));
  EXPECT_FALSE(Offset(10, 6.1, 0.4));
  EXPECT_TRUE(Offset(-5, 4.9, 0.4));
  EXPECT_FALSE(Offset(-5, 5.1, 0.4));
}

TEST(CollectPlacesTest, AllPointsOfLinksWithVertices) {
  FrontalScene scene;
  scene.Draw({{0, 0}, {2, 0}});
  scene.Draw({{0, 5}, {2, 5}});
  scene.Draw({{0, 9}, {1, 9}});
  scene.Freeze(1);
  scene.Build();
  const Places places = CollectPlaces(scene.graph);
  EXPECT_EQ(places.point,
            (std::vector<std::pair<LinkId, int>>{{0, 0}, {0, 1}, {0, 2}, {2, 0}, {2, 1}}));
  EXPECT_EQ(places.position.size(), 5u);
  EXPECT_EQ(places.position[4], FrontalPoint(1, 9));
}

// A link along two edges, of which the second is shown in one view only.
class FragmentsTest : public ::testing::Test {
 protected:
  FragmentsTest() {
    scene_.Show({{-60, 0}, {-10, 0}}, {0, 1});
    scene_.Show({{10, 0}, {60, 0}}, {1});
    scene_.Draw({{-60, 0}, {60, 0}});
    scene_.Build();
  }
  const DrawingLink& link() const { return scene_.graph.links[0]; }

  FrontalScene scene_;
};

TEST_F(FragmentsTest, AreThoseOfTheStretch) {
  EXPECT_EQ(FragmentsAtEnd(scene_.Input(), link(), 0), (FragmentsByView{{0, {0}}, {1, {0}}}));
  EXPECT_EQ(FragmentsAtEnd(scene_.Input(), link(), 1), (FragmentsByView{{1, {1}}}));
  // In the middle both are within 12 px.
  EXPECT_EQ(FragmentsAround(scene_.Input(), link(), 60), (FragmentsByView{{0, {0}}, {1, {0, 1}}}));
  EXPECT_EQ(FragmentsAround(scene_.Input(), link(), 40), (FragmentsByView{{0, {0}}, {1, {0}}}));
}

TEST(ImagesAgreeTest, BothComeNearThePointInEnoughViews) {
  FrontalScene scene;
  scene.ShowAndDraw({{-60, 0}, {-4, 0}}, {0, 1, 2, 3});
  scene.ShowAndDraw({{0, 60}, {0, 5}}, {1, 2, 3, 4});
  scene.Build();
  const TopologyInput input = scene.Input();
  const FragmentsByView a = FragmentsAtEnd(input, scene.graph.links[0], 1);
  const FragmentsByView b = FragmentsAtEnd(input, scene.graph.links[1], 1);
  EXPECT_TRUE(ImagesAgree(input, FrontalPoint(0, 0), a, b, 3));
  EXPECT_FALSE(ImagesAgree(input, FrontalPoint(0, 0), a, b, 4));
  // Too far from one of them.
  EXPECT_FALSE(ImagesAgree(input, FrontalPoint(3, 0), a, b, 1));
  EXPECT_FALSE(ImagesAgree(input, FrontalPoint(0, -2), a, b, 1));
  EXPECT_FALSE(ImagesAgree(input, FrontalPoint(0, 0), a, {}, 1));
}

// Links that leave the origin at these angles; the pairs at their node.
std::set<std::pair<LinkEnd, LinkEnd>> Paired(const std::vector<double>& angles_rad,
                                             double max_continuation_angle_deg = 30) {
  FrontalScene scene;
  for (const double angle : angles_rad) scene.Draw(testing::Ray({0, 0}, angle, 40));
  scene.Build();
  const NodeId node = testing::NodeAtPlace(scene.graph, FrontalPoint(0, 0));
  TopologyOptions options;
  options.max_continuation_angle_deg = max_continuation_angle_deg;
  PairContinuations(options, &scene.graph);
  return testing::Continuations(scene.graph.nodes[node]);
}
using Pairs = std::set<std::pair<LinkEnd, LinkEnd>>;

TEST(PairContinuationsTest, SmoothestPairsAreTaken) {
  EXPECT_EQ(Paired({0, M_PI, M_PI / 2}), (Pairs{{{0, 0}, {1, 0}}}));
  EXPECT_EQ(Paired({0, M_PI / 2, M_PI, -M_PI / 2}), (Pairs{{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}}));
  EXPECT_EQ(Paired({0.3, M_PI, -0.1}), (Pairs{{{1, 0}, {2, 0}}}));
}

// The ends of a ring that begins and ends at the origin, and of an arc of it that is cut there.
TEST(PairContinuationsTest, BendsGoOnThroughNodes) {
  // Between the middles of its tips, 8 px from its ends, this one turns by 76 degrees.
  constexpr double kRadiusPx = 12;
  for (const double radius_px : {3.0, 5.0, kRadiusPx}) {
    FrontalScene ring;
    ring.Draw(testing::RingThroughOrigin(radius_px));
    ring.Build();
    ring.graph.nodes[0].continuations.clear();
    PairContinuations({}, &ring.graph);
    EXPECT_EQ(testing::Continuations(ring.graph.nodes[0]), (Pairs{{{0, 0}, {0, 1}}}));
  }

  FrontalScene arcs;
  testing::PxLine left = testing::ArcFromOrigin(kRadiusPx, 2);
  arcs.Draw(left);
  for (Eigen::Vector2d& point : left) point.x() *= -1;
  arcs.Draw(left);
  arcs.Draw(testing::Ray({0, 0}, -M_PI / 2, 40));
  arcs.Build();
  const NodeId node = testing::NodeAtPlace(arcs.graph, FrontalPoint(0, 0));
  PairContinuations({}, &arcs.graph);
  EXPECT_EQ(testing::Continuations(arcs.graph.nodes[node]), (Pairs{{{0, 0}, {1, 0}}}));
}

TEST(PairContinuationsTest, BendsThatMeetAtACornerDoNotGoOn) {
  // Petals: both turn left.
  FrontalScene scene;
  testing::PxLine arc = testing::ArcFromOrigin(12, 2);
  scene.Draw(arc);
  for (Eigen::Vector2d& point : arc) point = {-point.y(), point.x()};
  scene.Draw(arc);
  scene.Build();
  const NodeId node = testing::NodeAtPlace(scene.graph, FrontalPoint(0, 0));
  PairContinuations({}, &scene.graph);
  EXPECT_EQ(testing::Continuations(scene.graph.nodes[node]), Pairs());
}

TEST(PairContinuationsTest, ClosedLinkWithACornerWhereItBeginsDoesNotGoOn) {
  FrontalScene scene;
  scene.Draw({{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}});
  scene.Build();
  ASSERT_TRUE(scene.graph.links[0].closed);
  PairContinuations({}, &scene.graph);
  EXPECT_EQ(testing::Continuations(scene.graph.nodes[0]), Pairs());
}

TEST(PairContinuationsTest, TurnIsAnOption) {
  const double turn = 40 * kDeg;
  EXPECT_EQ(Paired({turn, M_PI}, 39), Pairs());
  EXPECT_EQ(Paired({turn, M_PI}, 41), (Pairs{{{0, 0}, {1, 0}}}));
}

}  // namespace
}  // namespace limn
