// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/short_curves.h"

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// One link that is short and unlikely, and a long and likely one.
DrawingGraph ShortAndUnlikely() {
  DrawingGraph graph = testing::GraphOf({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {5, 1, 0}}});
  graph.links[1].curve_px = 350;
  graph.links[1].confidence = 0.95;
  for (DrawingLink& link : graph.links) link.supporting_views = {0, 1, 2, 3};
  graph.links[0].curve_px = 70;
  graph.links[0].confidence = 0.45;
  return graph;
}

LinkDoubt DoubtOf(DrawingGraph graph) {
  DoubtShortCurves(testing::DomeViews(8, 5), &graph);
  EXPECT_EQ(graph.links[0].tentative, graph.links[0].doubt != LinkDoubt::kNone);
  return graph.links[0].doubt;
}

TEST(ShortCurvesTest, WhatIsShortAndUnlikelyIsDoubted) {
  EXPECT_EQ(DoubtOf(ShortAndUnlikely()), LinkDoubt::kShort);
}

TEST(ShortCurvesTest, WhatIsLikelyOrPartOfALongCurveIsNot) {
  DrawingGraph likely = ShortAndUnlikely();
  likely.links[0].confidence = 0.55;
  EXPECT_EQ(DoubtOf(likely), LinkDoubt::kNone);
  DrawingGraph of_long = ShortAndUnlikely();
  of_long.links[0].curve_px = 80;
  EXPECT_EQ(DoubtOf(of_long), LinkDoubt::kNone);
}

TEST(ShortCurvesTest, WhereAllIsUncertainTheMeanTells) {
  DrawingGraph uncertain = ShortAndUnlikely();
  uncertain.links[1].confidence = 0.5;  // mean: 0.49
  EXPECT_EQ(DoubtOf(uncertain), LinkDoubt::kNone);
  uncertain.links[0].confidence = 0.3;  // 0.46
  EXPECT_EQ(DoubtOf(uncertain), LinkDoubt::kShort);
}

TEST(ShortCurvesTest, WhatHasNoConfidenceOrLengthIsNot) {
  DrawingGraph by_hand = ShortAndUnlikely();
  by_hand.links[0].confidence = -1;
  EXPECT_EQ(DoubtOf(by_hand), LinkDoubt::kNone);
  DrawingGraph unmeasured = ShortAndUnlikely();
  unmeasured.links[0].curve_px = 0;
  EXPECT_EQ(DoubtOf(unmeasured), LinkDoubt::kNone);
}

TEST(ShortCurvesTest, TextureRodsAndContoursHaveTheirOwnRules) {
  for (const LinkKind kind : {LinkKind::kTexture, LinkKind::kRod, LinkKind::kContour}) {
    DrawingGraph graph = ShortAndUnlikely();
    graph.links[0].kind = kind;
    EXPECT_EQ(DoubtOf(graph), LinkDoubt::kNone);
  }
}

TEST(ShortCurvesTest, DescribedAnewTheyAreBelievedAgain) {
  DrawingGraph graph = ShortAndUnlikely();
  DoubtShortCurves(testing::DomeViews(8, 5), &graph);
  graph.links[1].tentative = true;
  graph.links[1].doubt = LinkDoubt::kDepth;
  BelieveShortCurves(&graph);
  EXPECT_FALSE(graph.links[0].tentative);
  EXPECT_EQ(graph.links[0].doubt, LinkDoubt::kNone);
  EXPECT_EQ(graph.links[1].doubt, LinkDoubt::kDepth);
}

TEST(ShortCurvesTest, AnEarlierReasonStays) {
  DrawingGraph graph = ShortAndUnlikely();
  graph.links[0].tentative = true;
  graph.links[0].doubt = LinkDoubt::kDepth;
  const StageSummary summary = DoubtShortCurves(testing::DomeViews(8, 5), &graph);
  EXPECT_EQ(graph.links[0].doubt, LinkDoubt::kDepth);
  EXPECT_EQ(summary.dropped.at(0).second, 0);
}

}  // namespace
}  // namespace limn
