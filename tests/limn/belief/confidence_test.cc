// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/confidence.h"

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DomeViews;
using testing::GraphOf;

TEST(ConfidenceOf, ASureDrawingAndOneByAccident) {
  const LinkFacts usual = {15, 10, 0, 60};
  EXPECT_GT(ConfidenceOf(usual, 0.7), 0.9);
  EXPECT_LT(ConfidenceOf(usual, 0), 0.3);
  const LinkFacts weak = {3, 3, 2, 60};
  EXPECT_LT(ConfidenceOf(weak, 0.7), 0.5);
  EXPECT_LT(ConfidenceOf(weak, 0), 0.05);
}

TEST(ConfidenceOf, EveryFactCounts) {
  const double confidence = ConfidenceOf({10, 6, 1, 4}, 0.5);
  EXPECT_GT(ConfidenceOf({12, 6, 1, 4}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 7, 1, 4}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 6, 0, 4}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 6, 1, 5}, 0.5), confidence);
  EXPECT_GT(ConfidenceOf({10, 6, 1, 4}, 0.6), confidence);
}

TEST(ConfidenceOf, StaysAProbability) {
  EXPECT_EQ(ConfidenceOf({1e6, 10, 0, 60}, 0.5), ConfidenceOf({20, 10, 0, 60}, 0.5));
  EXPECT_LE(ConfidenceOf({1e6, 1000, 0, 90}, 1), 1);
  EXPECT_GE(ConfidenceOf({-1e3, 0, 2, 0}, 0), 0);
}

TEST(ConfidenceOf, InProportionToNarrowAngles) {
  const double wide = ConfidenceOf({10, 6, 1, 5}, 0.5);
  EXPECT_EQ(ConfidenceOf({10, 6, 1, 50}, 0.5), wide);
  EXPECT_EQ(ConfidenceOf({10, 6, 1, -1}, 0.5), wide);  // held by its nodes
  EXPECT_DOUBLE_EQ(ConfidenceOf({10, 6, 1, 1}, 0.5), wide / 5);
}

// Two links that meet and one by itself, of the same length, that all views see.
DrawingGraph PairAndOneMore() {
  DrawingGraph graph = GraphOf(
      {{{0, 0, 0}, {0.2, 0, 0}}, {{0.2, 0, 0}, {0.2, 0.2, 0}}, {{0, 0.3, 0}, {0.2, 0.3, 0}}});
  for (DrawingLink& link : graph.links) {
    link.supporting_views = {0, 1, 2, 3, 4, 5, 6, 7};
    link.evidence = 12;
    link.tri_angle_deg = 60;
  }
  return graph;
}

DrawingGraph Told(DrawingGraph graph) {
  TellConfidences(DomeViews(8, 5), &graph);
  testing::ExpectValid(graph);
  return graph;
}

TEST(TellConfidences, ByFreeEndsAndTheSureShareOfTheDrawing) {
  DrawingGraph graph = PairAndOneMore();
  const DrawingGraph told = Told(graph);
  EXPECT_NEAR(told.links[0].confidence, ConfidenceOf({12, 8, 1, 60}, 1), 1e-12);
  EXPECT_NEAR(told.links[2].confidence, ConfidenceOf({12, 8, 2, 60}, 1), 1e-12);
  graph.links[0].evidence = 10.9;
  graph.links[0].tentative = true;
  EXPECT_NEAR(Told(graph).links[2].confidence, ConfidenceOf({12, 8, 2, 60}, 2.0 / 3), 0.002);
}

TEST(TellConfidences, OfWhatStandsStillAndIsNotSure) {
  DrawingGraph graph = PairAndOneMore();
  for (DrawingLink& link : graph.links) {
    link.tentative = true;
    link.doubt = LinkDoubt::kStill;
  }
  EXPECT_NEAR(Told(graph).links[2].confidence, ConfidenceOf({12, 8, 2, 60}, 1), 1e-12);
  for (DrawingLink& link : graph.links) link.evidence = 10;
  EXPECT_NEAR(Told(graph).links[2].confidence, ConfidenceOf({10, 8, 2, 60}, 0) / 10, 1e-12);
}

TEST(TellConfidences, OfALoopWithoutFreeEnds) {
  DrawingGraph graph = GraphOf({{{0, 0, 0}, {0.2, 0, 0}, {0.1, 0.2, 0}, {0, 0, 0}}});
  graph.links[0].evidence = 12;
  EXPECT_NEAR(Told(graph).links[0].confidence, ConfidenceOf({12, 0, 0, -1}, 1), 1e-12);
}

TEST(TellConfidences, OfRodsButNotOfOutlinesAndWhatWasNotJudged) {
  DrawingGraph graph = PairAndOneMore();
  graph.links[0].kind = LinkKind::kContour;
  graph.links[1].evidence.reset();
  graph.links[1].confidence = 0.5;
  graph.links[2].kind = LinkKind::kRod;
  graph.links[2].kind_confidence = 0.75;
  graph.links[2].rod_radius = 0.01;
  graph.links[2].evidence.reset();
  const DrawingGraph told = Told(graph);
  EXPECT_EQ(told.links[0].confidence, -1);
  EXPECT_EQ(told.links[1].confidence, -1);
  EXPECT_EQ(told.links[2].confidence, 0.75);
}

}  // namespace
}  // namespace limn
