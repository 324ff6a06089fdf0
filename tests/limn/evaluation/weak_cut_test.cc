// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/weak_cut.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/angle_between.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::SizeIs;

constexpr int kNumViews = 12;

// A link of a cube's edge that these views support.
DrawingLink EdgeSeenBy(int edge, std::vector<ViewId> views) {
  DrawingLink link;
  link.points_in_world = testing::CubeEdges(0.8)[edge].points;
  link.supporting_views = std::move(views);
  return link;
}

// All edges of a cube, each drawn by groups of views of their own.
DrawingGraph DrawnBy(const std::vector<std::vector<ViewId>>& groups) {
  DrawingGraph graph;
  for (int edge = 0; edge < 12; ++edge) {
    for (const std::vector<ViewId>& group : groups) graph.links.push_back(EdgeSeenBy(edge, group));
  }
  return graph;
}

std::optional<WeakCut> CutOf(const DrawingGraph& graph) {
  return FindWeakCut(kNumViews, MeasureSharedSupport(testing::DomeViews(kNumViews, 5), graph));
}

TEST(MeasureSharedSupport, IsWhatBothViewsSupportOfWhatOneDoes) {
  const std::vector<View> views = testing::DomeViews(3, 5);
  DrawingGraph graph;
  graph.links = {EdgeSeenBy(0, {0, 1}), EdgeSeenBy(1, {0})};
  graph.links.push_back(EdgeSeenBy(2, {0, 2}));
  graph.links.back().kind = LinkKind::kContour;
  const auto pairs = MeasureSharedSupport(views, graph);
  ASSERT_THAT(pairs, SizeIs(4));  // 0 to 1 and 2, 1 to 0 and 2
  EXPECT_EQ(pairs[0].from, 0);
  EXPECT_EQ(pairs[0].to, 1);
  EXPECT_NEAR(pairs[0].shared_px / pairs[0].promised_px, 0.5, 0.1);
  EXPECT_EQ(pairs[1].shared_px, 0);
  EXPECT_EQ(pairs[2].shared_px, pairs[2].promised_px);
  const double angle = AngleBetween(views[0].CenterInWorld(), views[1].CenterInWorld()) / kDeg;
  EXPECT_NEAR(pairs[0].angle_deg, angle, 0.3 * angle);
  EXPECT_EQ(pairs[0].angle_deg > 0, true);
}

TEST(FindWeakCut, ViewsThatFitHaveNone) {
  EXPECT_FALSE(CutOf(DrawnBy({{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}})));
  EXPECT_FALSE(CutOf(DrawnBy({})));
}

TEST(FindWeakCut, HalvesThatDrawTheirOwnCurvesAreFound) {
  const auto cut = CutOf(DrawnBy({{0, 2, 4, 6, 8, 10, 11}, {1, 3, 5, 7, 9}}));
  ASSERT_TRUE(cut);
  EXPECT_THAT(cut->smaller, ElementsAre(1, 3, 5, 7, 9));
  EXPECT_LT(cut->shared, 0.2);
  EXPECT_GT(cut->explained, 0.8);
}

// Views lack other parts of the edges each: that is not a cut.
TEST(FindWeakCut, WhatSingleViewsLackIsNoCut) {
  constexpr int kParts = 10;
  DrawingGraph graph;
  std::minstd_rand random(1);
  for (int i = 0; i < 12 * kParts; ++i) {
    std::vector<ViewId> views;
    for (ViewId v = 0; v < kNumViews; ++v) {
      if (random() % 4 != 0) views.push_back(v);
    }
    DrawingLink link = EdgeSeenBy(i / kParts, views);
    const Eigen::Vector3d from = link.points_in_world.front(), to = link.points_in_world.back();
    link.points_in_world = {from + (to - from) * (i % kParts) / kParts,
                            from + (to - from) * (i % kParts + 1) / kParts};
    graph.links.push_back(link);
  }
  EXPECT_FALSE(CutOf(graph));
}

// Nor does it matter that a whole group sees less than the other.
TEST(FindWeakCut, WeakerViewsAreNoGroup) {
  DrawingGraph graph;
  for (int edge = 0; edge < 12; ++edge) {
    std::vector<ViewId> views = {0, 1, 2, 3, 4, 5};
    if (edge % 2 == 0) views.insert(views.end(), {6, 7, 8, 9, 10, 11});
    graph.links.push_back(EdgeSeenBy(edge, views));
  }
  EXPECT_FALSE(CutOf(graph));
}

}  // namespace
}  // namespace limn
