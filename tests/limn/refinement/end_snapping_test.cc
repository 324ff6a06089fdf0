#include <gtest/gtest.h>

#include "limn/refinement/edit_fixture.h"

namespace limn {
namespace {

using testing::EditScene;
using testing::PxLine;

// A link along the x axis, and one from above that ends `gap_px` over its middle.
EditScene Above(double gap_px) {
  EditScene scene;
  scene.Draw({{-60, 0}, {60, 0}});
  scene.Draw({{0, 60}, {0, gap_px}});
  return scene;
}
EditScene AboveOnAnEdge(double gap_px) {
  EditScene scene = Above(gap_px);
  scene.Show({{0, 60}, {0, 0}});
  return scene;
}

void ExpectTJunction(const EditScene& scene) {
  ASSERT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
  ASSERT_EQ(scene.Degree(0, 0), 3);
  EXPECT_NEAR(scene.TotalPx(), 180, 1e-6);
  // The two parts of the link that was cut go on in each other.
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {2, 0}}}));
}

TEST(SnapEndsTest, EndNearTheInsideOfALinkMakesATJunction) {
  EditScene scene = Above(2.9);
  const SnapCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_links, 1);
  EXPECT_EQ(counts.to_nodes, 0);
  ExpectTJunction(scene);
  EXPECT_EQ(Above(3.1).Snap().to_links, 0);
}

TEST(SnapEndsTest, LargerGapsNeedEdgels) {
  for (const double gap_px : {3.1, 11.9}) {
    EditScene scene = AboveOnAnEdge(gap_px);
    EXPECT_EQ(scene.Snap().to_links, 1);
    ExpectTJunction(scene);
    // Those of enough views.
    EditScene few = Above(gap_px);
    few.Show({{0, 60}, {0, 0}}, {0, 1});
    EXPECT_EQ(few.Snap().to_links, 0);
  }
  EXPECT_EQ(AboveOnAnEdge(12.1).Snap().to_links, 0);
}

TEST(SnapEndsTest, WhatOvershootsIsCut) {
  EditScene scene = Above(-2.9);
  EXPECT_EQ(scene.Snap().to_links, 1);
  ExpectTJunction(scene);
  EXPECT_EQ(AboveOnAnEdge(-3.1).Snap().to_links, 0);
}

TEST(SnapEndsTest, LinksPartInsideALink) {
  // An end 2 px from the middle of a link, in a direction.
  const auto snapped = [](double angle_rad) {
    EditScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw(testing::Ray(2 * testing::Unit(angle_rad), angle_rad, 60));
    return scene.Snap().to_links;
  };
  EXPECT_EQ(snapped(0.46), 1);
  EXPECT_EQ(snapped(M_PI - 0.46), 1);
  EXPECT_EQ(snapped(0.42), 0);
  EXPECT_EQ(snapped(M_PI - 0.42), 0);
}

// Two links that meet at the origin, and one from the right whose line passes `miss_px` above.
EditScene BesideANode(double gap_px, double miss_px) {
  EditScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{0, 0}, {0, -60}});
  scene.Draw({{60, miss_px}, {gap_px, miss_px}});
  return scene;
}

TEST(SnapEndsTest, EndNearANodeEndsThere) {
  EditScene scene = BesideANode(2, 1.4);
  const SnapCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
  EXPECT_EQ(scene.Degree(0, 0), 3);
  EXPECT_EQ(BesideANode(2, 1.6).Snap().to_nodes, 0);
}

TEST(SnapEndsTest, GapToANode) {
  const auto snapped = [](double gap_px, bool shown) {
    EditScene scene = BesideANode(gap_px, 0);
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

TEST(SnapEndsTest, LinksPartAtANode) {
  // The second link comes to the end of two others from the side of the first one.
  const auto snapped = [](double angle_rad) {
    EditScene scene;
    scene.Draw({{-60, 0}, {0, 0}});
    scene.Draw({{0, 0}, {0, -60}});
    scene.Draw(testing::Ray(2 * testing::Unit(M_PI - angle_rad), M_PI - angle_rad, 60));
    return scene.Snap();
  };
  EXPECT_EQ(snapped(0.46).to_nodes, 1);
  EXPECT_EQ(snapped(0.42).to_nodes, 0);
  EXPECT_EQ(snapped(0.42).to_links, 0);
}

TEST(SnapEndsTest, EndThatGoesOnInALinkThereIsItsContinuation) {
  const auto continuations = [](double turn_rad) {
    EditScene scene;
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

TEST(SnapEndsTest, WhatGoesOnAlreadyIsNotContinuedTwice) {
  EditScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw(testing::Ray({0, 0}, -0.3, 60));
  scene.graph.nodes[testing::NodeAtPlace(scene.graph, testing::FrontalPoint(0, 0))]
      .continuations = {{{0, 1}, {1, 0}}};
  scene.Draw(testing::Ray(2 * testing::Unit(0.3), 0.3, 60));
  EXPECT_EQ(scene.Snap().to_nodes, 1);
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {1, 0}}}));
}

TEST(SnapEndsTest, NodeIsPreferredToAPlaceCloseBy) {
  EditScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{-1.4, 60}, {-1.4, 2}});
  const SnapCounts counts = scene.Snap();
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.to_links, 0);
  // Farther away the link is cut.
  EditScene away;
  away.Draw({{-60, 0}, {0, 0}});
  away.Draw({{-6, 60}, {-6, 2}});
  EXPECT_EQ(away.Snap().to_links, 1);
  EXPECT_EQ(away.Degree(-6, 0), 3);
}

TEST(SnapEndsTest, OfTwoFreeEndsOneMoves) {
  // Each is the other's target.
  EditScene facing;
  facing.Draw({{-60, 0}, {0, 0}});
  facing.Draw({{2, 0}, {60, 0}});
  EXPECT_EQ(facing.Snap().to_nodes, 1);
  EXPECT_EQ(facing.graph.links.size(), 2u);
  EXPECT_EQ(facing.graph.nodes.size(), 3u);
  EXPECT_NEAR(facing.TotalPx(), 120, 1e-6);
}

TEST(SnapEndsTest, PlacesCloseByShareANode) {
  const auto scene_with = [](double apart_px) {
    EditScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw({{0, 60}, {0, 2}});
    scene.Draw({{apart_px, -60}, {apart_px, -2}});
    EXPECT_EQ(scene.Snap().to_links, 2);
    return scene;
  };
  EXPECT_EQ(scene_with(2).graph.nodes.size(), 5u);
  EXPECT_EQ(scene_with(2).graph.links.size(), 4u);
  const EditScene apart = scene_with(6);
  EXPECT_EQ(apart.graph.links.size(), 5u);
  EXPECT_EQ(apart.Degree(0, 0), 3);
  EXPECT_EQ(apart.Degree(6, 0), 3);
  EXPECT_EQ(testing::Continuations(apart.Node(0, 0)).size(), 1u);
  EXPECT_EQ(testing::Continuations(apart.Node(6, 0)).size(), 1u);
}

// A ring with its anchor at the origin and its center above, and an end under it.
EditScene UnderARing(const std::vector<double>& ends_x) {
  EditScene scene;
  PxLine ring = testing::Arc(40, 2 * M_PI);
  ring.back() = ring.front();
  scene.Draw(ring);
  for (const double x : ends_x) scene.Draw({{x, -60}, {x, -2}});
  return scene;
}

TEST(SnapEndsTest, LoopIsOpenedWhereAnEndMeetsIt) {
  EditScene scene = UnderARing({5});
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

TEST(SnapEndsTest, LoopIsOpenedOnlyOnce) {
  EditScene scene = UnderARing({-8, 8});
  EXPECT_EQ(scene.Snap().to_links, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  // The next time it is a link like others.
  EXPECT_EQ(scene.Snap().to_links, 1);
  EXPECT_EQ(scene.graph.links.size(), 4u);
  EXPECT_EQ(scene.graph.nodes.size(), 4u);
}

TEST(SnapEndsTest, FrozenLinksAreLeftAlone) {
  for (const LinkId frozen : {0, 1}) {
    EditScene scene = Above(2);
    scene.Freeze(frozen);
    const Polyline3d before = scene.graph.links[frozen].points_in_world;
    EXPECT_EQ(scene.Snap().to_links, 0);
    EXPECT_EQ(scene.graph.links[frozen].points_in_world, before);
  }
}

}  // namespace
}  // namespace limn
