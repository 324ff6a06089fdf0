// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;

// Ends of links that were fitted to the images: see snap_ends_test.cc for others.

// A link along the x axis, and one from above that ends `gap_px` over its middle.
FrontalScene Above(double gap_px) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {60, 0}});
  scene.Draw({{0, 60}, {0, gap_px}});
  return scene;
}
FrontalScene AboveOnAnEdge(double gap_px) {
  FrontalScene scene = Above(gap_px);
  scene.Show({{-60, 0}, {60, 0}});
  scene.Show({{0, 60}, {0, 0}});
  return scene;
}

void ExpectTJunction(const FrontalScene& scene) {
  ASSERT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
  ASSERT_EQ(scene.Degree(0, 0), 3);
  EXPECT_NEAR(scene.TotalPx(), 180, 1e-6);
  // The two parts of the link that was cut continue each other.
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {2, 0}}}));
}

TEST(SnapFittedEndsTest, EndNearTheInsideOfALinkMakesATJunction) {
  FrontalScene scene = Above(2.9);
  const MeetingCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_links, 1);
  EXPECT_EQ(counts.to_nodes, 0);
  ExpectTJunction(scene);
  EXPECT_EQ(Above(3.1).Snap().to_links, 0);
}

TEST(SnapFittedEndsTest, LargerGapsNeedTheImages) {
  for (const double gap_px : {3.1, 11.9}) {
    FrontalScene scene = AboveOnAnEdge(gap_px);
    EXPECT_EQ(scene.Snap().to_links, 1);
    ExpectTJunction(scene);
    // Those of enough views.
    FrontalScene few = Above(gap_px);
    few.Show({{-60, 0}, {60, 0}});
    few.Show({{0, 60}, {0, 0}}, {0, 1});
    EXPECT_EQ(few.Snap().to_links, 0);
  }
  EXPECT_EQ(AboveOnAnEdge(12.1).Snap().to_links, 0);
}

TEST(SnapFittedEndsTest, WhatOvershootsIsCut) {
  FrontalScene scene = Above(-2.9);
  EXPECT_EQ(scene.Snap().to_links, 1);
  ExpectTJunction(scene);
  EXPECT_EQ(AboveOnAnEdge(-3.1).Snap().to_links, 0);
}

TEST(SnapFittedEndsTest, LinksPartInsideALink) {
  // An end 2 px from the middle of a link, in a direction.
  const auto snapped = [](double angle_rad) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw(testing::Ray(2 * testing::Unit(angle_rad), angle_rad, 60));
    return scene.Snap().to_links;
  };
  EXPECT_EQ(snapped(0.46), 1);
  EXPECT_EQ(snapped(M_PI - 0.46), 1);
  EXPECT_EQ(snapped(0.42), 0);
  EXPECT_EQ(snapped(M_PI - 0.42), 0);
}

TEST(SnapFittedEndsTest, AngleIsAnOption) {
  const auto snapped = [](double min_junction_angle_deg) {
    FrontalScene scene;
    scene.options.min_junction_angle_deg = min_junction_angle_deg;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw(testing::Ray(2 * testing::Unit(0.7), 0.7, 60));  // 40.1 degrees
    return scene.Snap().to_links;
  };
  EXPECT_EQ(snapped(39), 1);
  EXPECT_EQ(snapped(41), 0);
}

// Two links that meet at the origin, and one from the right whose line passes `miss_px` above.
FrontalScene BesideANode(double gap_px, double miss_px) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{0, 0}, {0, -60}});
  scene.Draw({{60, miss_px}, {gap_px, miss_px}});
  return scene;
}

TEST(SnapFittedEndsTest, EndNearANodeEndsThere) {
  FrontalScene scene = BesideANode(2, 1.4);
  const MeetingCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
  EXPECT_EQ(scene.Degree(0, 0), 3);
  EXPECT_EQ(BesideANode(2, 1.6).Snap().to_nodes, 0);
}

TEST(SnapFittedEndsTest, GapToANode) {
  const auto snapped = [](double gap_px, bool shown) {
    FrontalScene scene = BesideANode(gap_px, 0);
    if (shown) scene.Show({{-10, 0}, {60, 0}});
    return scene.Snap().to_nodes;
  };
  EXPECT_EQ(snapped(2.9, false), 1);
  EXPECT_EQ(snapped(3.1, false), 0);
  EXPECT_EQ(snapped(3.1, true), 1);
  EXPECT_EQ(snapped(11.9, true), 1);
  EXPECT_EQ(snapped(12.1, true), 0);
  EXPECT_EQ(snapped(-2.9, false), 1);
  EXPECT_EQ(snapped(-3.1, true), 0);
}

TEST(SnapFittedEndsTest, LinksPartAtANode) {
  // The second link comes to the end of two others from the side of the first one.
  const auto snapped = [](double angle_rad) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {0, 0}});
    scene.Draw({{0, 0}, {0, -60}});
    scene.Draw(testing::Ray(2 * testing::Unit(M_PI - angle_rad), M_PI - angle_rad, 60));
    return scene.Snap();
  };
  EXPECT_EQ(snapped(0.46).to_nodes, 1);
  EXPECT_EQ(snapped(0.42).to_nodes, 0);
  EXPECT_EQ(snapped(0.42).to_links, 0);
}

TEST(SnapFittedEndsTest, EndThatGoesOnInALinkThereIsItsContinuation) {
  const auto continuations = [](double turn_rad) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {0, 0}});
    scene.Draw({{0, 0}, {0, -60}});
    scene.Draw(testing::Ray(2 * testing::Unit(turn_rad), turn_rad, 60));
    EXPECT_EQ(scene.Snap().to_nodes, 1);
    return testing::Continuations(scene.Node(0, 0));
  };
  const std::set<std::pair<LinkEnd, LinkEnd>> straight_on = {{{0, 1}, {2, 0}}};
  EXPECT_EQ(continuations(0), straight_on);
  EXPECT_EQ(continuations(0.50), straight_on);
  EXPECT_TRUE(continuations(0.54).empty());
}

TEST(SnapFittedEndsTest, EndThatGoesOnLessSmoothlyIsNoContinuation) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw(testing::Ray({0, 0}, -0.2, 60));
  scene.Draw(testing::Ray(2 * testing::Unit(0.3), 0.3, 60));
  EXPECT_EQ(scene.Snap().to_nodes, 1);
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {1, 0}}}));
}

TEST(SnapFittedEndsTest, NodeIsPreferredToAPlaceCloseBy) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{-1.4, 60}, {-1.4, 2}});
  const MeetingCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.to_links, 0);
  // Farther away the link is cut.
  FrontalScene away;
  away.Draw({{-60, 0}, {0, 0}});
  away.Draw({{-6, 60}, {-6, 2}});
  EXPECT_EQ(away.Snap().to_links, 1);
  EXPECT_EQ(away.Degree(-6, 0), 3);
}

TEST(SnapFittedEndsTest, OfTwoFreeEndsOneMoves) {
  // Each is the other's target.
  FrontalScene facing;
  facing.Draw({{-60, 0}, {0, 0}});
  facing.Draw({{2, 0}, {60, 0}});
  EXPECT_EQ(facing.Snap().to_nodes, 1);
  EXPECT_EQ(facing.graph.links.size(), 2u);
  EXPECT_EQ(facing.graph.nodes.size(), 3u);
  EXPECT_NEAR(facing.TotalPx(), 120, 1e-6);
}

TEST(SnapFittedEndsTest, PlacesCloseByShareANode) {
  const auto scene_with = [](double apart_px) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw({{0, 60}, {0, 2}});
    scene.Draw({{apart_px, -60}, {apart_px, -2}});
    EXPECT_EQ(scene.Snap().to_links, 2);
    return scene;
  };
  EXPECT_EQ(scene_with(2).graph.nodes.size(), 5u);
  EXPECT_EQ(scene_with(2).graph.links.size(), 4u);
  const FrontalScene apart = scene_with(6);
  EXPECT_EQ(apart.graph.links.size(), 5u);
  EXPECT_EQ(apart.Degree(0, 0), 3);
  EXPECT_EQ(apart.Degree(6, 0), 3);
  EXPECT_EQ(testing::Continuations(apart.Node(0, 0)).size(), 1u);
  EXPECT_EQ(testing::Continuations(apart.Node(6, 0)).size(), 1u);
}

// A ring with its anchor at the origin and its center above, and an end under it.
FrontalScene UnderARing(const std::vector<double>& ends_x) {
  FrontalScene scene;
  scene.Draw(testing::RingThroughOrigin(40));
  for (const double x : ends_x) scene.Draw({{x, -60}, {x, -2}});
  return scene;
}

TEST(SnapFittedEndsTest, LoopIsOpenedWhereAnEndMeetsIt) {
  FrontalScene scene = UnderARing({5});
  const double ring_px = scene.LengthPx(0);
  EXPECT_EQ(scene.Snap().to_links, 1);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  EXPECT_EQ(scene.graph.nodes.size(), 2u);
  EXPECT_FALSE(scene.graph.links[0].closed);
  EXPECT_NEAR(scene.LengthPx(0), ring_px, 0.5);
  const NodeId node = scene.graph.links[0].node0;
  EXPECT_EQ(scene.graph.links[0].node1, node);
  EXPECT_EQ(scene.graph.nodes[node].Degree(), 3);
  EXPECT_EQ(testing::Continuations(scene.graph.nodes[node]),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 0}, {0, 1}}}));
}

TEST(SnapFittedEndsTest, LoopIsOpenedOnlyOnce) {
  FrontalScene scene = UnderARing({-8, 8});
  EXPECT_EQ(scene.Snap().to_links, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  // The next time it is a link like others.
  EXPECT_EQ(scene.Snap().to_links, 1);
  EXPECT_EQ(scene.graph.links.size(), 4u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
}

TEST(SnapFittedEndsTest, FrozenLinksAreLeftAlone) {
  for (const LinkId frozen : {0, 1}) {
    FrontalScene scene = Above(2);
    scene.Freeze(frozen);
    const Polyline3d before = scene.graph.links[frozen].points_in_world;
    EXPECT_EQ(scene.Snap().to_links, 0);
    EXPECT_EQ(scene.graph.links[frozen].points_in_world, before);
  }
}

TEST(SnapFittedEndsTest, FrozenLinksAreTargetsByTheirSharedNodes) {
  // At the node a frozen link meets another one.
  for (const LinkId frozen : {0, 1}) {
    FrontalScene scene = BesideANode(2, 0);
    scene.Freeze(frozen);
    EXPECT_EQ(scene.Snap().to_nodes, 1);
    EXPECT_EQ(scene.Degree(0, 0), 3);
    EXPECT_EQ(scene.graph.links[frozen].points_in_world.size(), 2u);
  }
}

}  // namespace
}  // namespace limn
