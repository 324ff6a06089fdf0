// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/tidy.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"
#include "limn/topology/graph_fixture.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::Arc;
using testing::DrawingSceneTest;
using testing::LinkTraits;
using testing::Moved;
using testing::Path;
using testing::Picture;
using testing::Polar;

class TidyTest : public DrawingSceneTest {
 protected:
  // Two links that meet alone in a node, with this turn.
  void AddMeeting(double turn_deg) {
    scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
    scene_.AddLink(Path({{0, 0, 0}, Polar(50, turn_deg)}));
    scene_.ShareNode({0, 0, 0});
  }

  // A line along x through a node at the origin.
  void AddCutBar() { AddMeeting(0); }

  void ExpectSamples(const TidyCounts& counts) {
    EXPECT_EQ(scene_.Look().NumSamples() + counts.samples_short + counts.samples_covered,
              scene_.NumSketchSamples());
  }
};

TEST_P(TidyTest, SmoothNodeOfTwoDissolves) {
  AddMeeting(28);
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.dissolved_nodes, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumMeetings(), 0);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 100, 1e-6);
  EXPECT_EQ(picture.LinkAt({0, 0, 0}).points.size(), 101u);
  EXPECT_TRUE(picture.HasFreeEndAt({-50, 0, 0}));
  EXPECT_TRUE(picture.HasFreeEndAt(Polar(50, 28)));
  ExpectSamples(counts);
}

TEST_P(TidyTest, SharpNodeOfTwoStays) {
  AddMeeting(32);
  EXPECT_EQ(scene_.Tidy().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(TidyTest, TurnLimitIsAnOption) {
  AddMeeting(40);
  EXPECT_EQ(scene_.Tidy({.max_continuation_angle_deg = 38}).dissolved_nodes, 0);
  EXPECT_EQ(scene_.Tidy({.max_continuation_angle_deg = 42}).dissolved_nodes, 1);
}

TEST_P(TidyTest, NodeOfThreeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 40, 0}}));
  EXPECT_EQ(scene_.Tidy().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(TidyTest, ChainOfSmoothNodesBecomesOneLink) {
  for (const double x : {-60, 20, -20}) scene_.AddLink(Path({{x, 0, 0}, {x + 40, 0, 0}}));
  scene_.ShareNode({-20, 0, 0});
  scene_.ShareNode({20, 0, 0});
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.dissolved_nodes, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
  ExpectSamples(counts);
}

TEST_P(TidyTest, LinkThatReturnsToItsNodeCloses) {
  scene_.AddLink(Arc({0, 0, 0}, 30, 0, 360));
  scene_.ShareNode({30, 0, 0});
  const TidyCounts counts = scene_.Tidy();
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  EXPECT_EQ(picture.NumMeetings(), 0);
  EXPECT_TRUE(picture.LinksAdvance());
  EXPECT_NEAR(picture.LengthPxAt({30, 0, 0}), 2 * M_PI * 30, 0.1);
  ExpectSamples(counts);
}

TEST_P(TidyTest, TwoArcsBecomeOneLoop) {
  // The last 14 px of each turn by 57 degrees.
  scene_.AddLink(Arc({0, 0, 0}, 14, 0, 180));
  scene_.AddLink(Arc({0, 0, 0}, 14, 360, 180));
  scene_.ShareNode({14, 0, 0});
  scene_.ShareNode({-14, 0, 0});
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_EQ(scene_.Look().NumClosed(), 1);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
  ExpectSamples(counts);
}

TEST_P(TidyTest, ShortFreeLinksGo) {
  scene_.AddLink(Path({{0, 0, 0}, {13, 0, 0}}));
  scene_.AddLink(Path({{0, 30, 0}, {15, 30, 0}}));
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.samples_short, 14);
  EXPECT_EQ(counts.samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 15, 1e-6);
  ExpectSamples(counts);
}

TEST_P(TidyTest, ShortestLengthIsAnOption) {
  scene_.AddLink(Path({{0, 0, 0}, {10, 0, 0}}));
  EXPECT_EQ(scene_.Tidy({.min_link_length_px = 9}).samples_short, 0);
  EXPECT_EQ(scene_.Tidy({.min_link_length_px = 11}).samples_short, 11);
  EXPECT_EQ(scene_.Look().NumLinks(), 0);
}

TEST_P(TidyTest, ShortHangingLinkGoesAndItsNodeDissolves) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 13, 0}}));
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.samples_short, 14);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 100, 1e-6);
  ExpectSamples(counts);
}

TEST_P(TidyTest, LongerHangingLinkStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 15, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_short, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(TidyTest, ShortBridgeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 5, -50}, {0, 5, 0}}));
  scene_.AddLink(Path({{0, 5, 0}, {0, 5, 50}}));
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}));
  scene_.ShareNode({0, 5, 0});
  EXPECT_EQ(scene_.Tidy().samples_short, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 5);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 5, 0}), 3);
}

TEST_P(TidyTest, BridgeOfNoLengthGoes) {
  AddCutBar();
  scene_.AddLink(Path({{0, 1, -50}, {0, 1, 0}}));
  scene_.AddLink(Path({{0, 1, 0}, {0, 1, 50}}));
  scene_.AddLink(Path({{0, 0, 0}, {0, 1, 0}}));
  scene_.ShareNode({0, 1, 0});
  EXPECT_EQ(scene_.Tidy().samples_short, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(TidyTest, SmallLoopAtANodeIsNoBridge) {
  AddCutBar();
  scene_.AddLink(Arc({0, 2, 0}, 2, -90, 270));
  EXPECT_EQ(scene_.Tidy().dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(TidyTest, ShortGrownLinkAtANodeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}), {.grown = true});
  EXPECT_EQ(scene_.Tidy().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(TidyTest, ShortGrownLinkAloneGoes) {
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}), {.grown = true});
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(scene_.Look().NumLinks(), 0);
  // Its samples are not of the sketch.
  EXPECT_EQ(counts.samples_short, 0);
}

TEST_P(TidyTest, LinkIsGrownOnlyAsAWhole) {
  // A short grown link fuses with a short one that is not: what hangs at the corner is short.
  AddMeeting(90);
  scene_.AddLink(Path({{0, 0, 0}, {-4, -4, 0}}), {.grown = true});
  scene_.AddLink(Path({{-4, -4, 0}, {-7, -7, 0}}));
  scene_.ShareNode({-4, -4, 0});
  scene_.Tidy();
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(TidyTest, ShortPiecesThatFuseToALongOneStay) {
  scene_.AddLink(Path({{-8, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, 0, 0}, {8, 0, 0}}));
  scene_.ShareNode({0, 0, 0});
  EXPECT_EQ(scene_.Tidy().samples_short, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(TidyTest, WhatHangsByShortLinksGoesInTurn) {
  // A stem on the bar bears two twigs. Without them the stem hangs, without it the bar is whole.
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 10, 0}}));
  scene_.AddLink(Path({{0, 10, 0}, {7, 17, 0}}));
  scene_.AddLink(Path({{0, 10, 0}, {-7, 17, 0}}));
  scene_.ShareNode({0, 10, 0});
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.samples_short, scene_.NumSketchSamples() - 2 * 51);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 100, 1e-6);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({50, 0, 0}));
  ExpectSamples(counts);
}

TEST_P(TidyTest, ShorterOfTwoThatRunTogetherGoes) {
  scene_.AddLink(Path({{-20, 0.5, 0}, {20, 0.5, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.samples_covered, 41);
  EXPECT_EQ(counts.samples_short, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  ExpectSamples(counts);
}

TEST_P(TidyTest, OneOfTwoAlikeStays) {
  scene_.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}));
  scene_.AddLink(Path({{-20, 0.5, 0}, {20, 0.5, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 41);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(TidyTest, ParallelLinksStay) {
  scene_.AddLink(Path({{-20, 3, 0}, {20, 3, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(TidyTest, CoveredShareIsAnOption) {
  // Along the other for 28 of 40 px.
  scene_.AddLink(Path({{-28, 0.5, 0}, {0, 0.5, 0}, {0, 12.5, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.Tidy({.covered_share = 0.75}).samples_covered, 0);
  EXPECT_EQ(scene_.Tidy({.covered_share = 0.65}).samples_covered, 41);
}

TEST_P(TidyTest, UncertainDepthCoversFurther) {
  // 1.2 px apart in height, of which the upper link knows its own to 1 px.
  const Eigen::Matrix3d uncertain = Vector3d(100, 100, 1).asDiagonal();
  scene_.AddLink(Path({{-20, 0, 1.2}, {20, 0, 1.2}}), {.information = uncertain});
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 41);
}

TEST_P(TidyTest, CertainDepthDoesNot) {
  // Known to 0.1 px.
  scene_.AddLink(Path({{-20, 0, 1.2}, {20, 0, 1.2}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 0);
}

TEST_P(TidyTest, LinkThatLeavesTheOtherStays) {
  // Along it for half of its length.
  scene_.AddLink(Path({{-30, 0.5, 0}, {0, 0.5, 0}, {20, 20, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(TidyTest, LinkThatTouchesTheOtherOverMostOfItsLengthGoes) {
  // Along it for 40 of 44 px.
  scene_.AddLink(Path({{-40, 0.5, 0}, {0, 0.5, 0}, {3, 3.5, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_GT(scene_.Tidy().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(TidyTest, CrossedLinksStay) {
  // Rungs on which a link across lies: near to all of its points, along none.
  scene_.AddLink(Path({{0, -15, 0}, {0, 15, 0}}));
  for (int k = -10; k <= 10; ++k) scene_.AddLink(Path({{-25, 1.5 * k, 0}, {25, 1.5 * k, 0}}));
  EXPECT_EQ(scene_.Tidy().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 22);
}

TEST_P(TidyTest, ForksAreCutFirst) {
  // The strand that leaves the line by 10 degrees is freed, and the line becomes whole.
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, Polar(40, 10)}));
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.forks_cut, 1);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_TRUE(scene_.Look().Covers({{-50, 0, 0}, {50, 0, 0}}, 1e-6));
}

TEST_P(TidyTest, TidyDrawingStaysAsItIs) {
  AddMeeting(90);
  scene_.Tidy();
  const TidyCounts counts = scene_.Tidy();
  EXPECT_EQ(counts.forks_cut + counts.dissolved_nodes, 0);
  EXPECT_EQ(counts.samples_covered + counts.samples_short, 0);
}

LIMN_ALL_VARIANTS(TidyTest);

class CutForksTest : public DrawingSceneTest {
 protected:
  // Links that leave the origin.
  struct Ray {
    double angle_deg;
    double length_px;
  };
  void AddStar(const std::vector<Ray>& rays) {
    for (const Ray& ray : rays) {
      scene_.AddLink(Path({{0, 0, 0}, Polar(ray.length_px, ray.angle_deg)}));
    }
    scene_.ShareNode({0, 0, 0});
  }
  // Cuts forks only; what remains leaves the node as it was.
  int64_t Cut(const TopologyOptions& options = {}) {
    graph_ = scene_.Graph();
    GraphEditor editor(&graph_);
    const int64_t num_cut = CutForks(options, &editor);
    testing::ExpectValid(graph_);
    return num_cut;
  }
  // Whether the link of a ray is still at the node of them all.
  bool IsAtNode(int ray) const {
    for (const DrawingNode& node : graph_.nodes) {
      if (node.Degree() < 2) continue;
      return std::any_of(node.incident.begin(), node.incident.end(),
                         [&](const LinkEnd& end) { return end.link == ray; });
    }
    return false;
  }

  DrawingGraph graph_;
};

TEST_P(CutForksTest, StrandThatPartsSlowlyIsFreed) {
  // The short one continues into the trunk, the long one turns more.
  AddStar({{180, 40}, {15, 60}, {0, 30}});
  EXPECT_EQ(Cut(), 1);
  EXPECT_TRUE(IsAtNode(0));
  EXPECT_FALSE(IsAtNode(1));
  EXPECT_TRUE(IsAtNode(2));
  EXPECT_EQ(testing::DegreeAt(graph_, Vector3d::Zero()), 2);
}

TEST_P(CutForksTest, TheLongerStaysIfBothTurnAlike) {
  AddStar({{180, 40}, {10, 30}, {-10, 60}});
  EXPECT_EQ(Cut(), 1);
  EXPECT_FALSE(IsAtNode(1));
  EXPECT_TRUE(IsAtNode(2));
}

TEST_P(CutForksTest, JunctionsStay) {
  AddStar({{180, 40}, {30, 40}, {-30, 40}});
  EXPECT_EQ(Cut(), 0);
}

TEST_P(CutForksTest, PlainCornersStay) {
  AddStar({{10, 40}, {-10, 40}});
  EXPECT_EQ(Cut(), 0);
}

TEST_P(CutForksTest, CornerWithADoubledEdgeKeepsItsThree) {
  AddStar({{0, 40}, {90, 40}, {182, 40}, {5, 20}});
  EXPECT_EQ(Cut(), 1);
  EXPECT_FALSE(IsAtNode(3));
}

TEST_P(CutForksTest, AngleIsAnOption) {
  AddStar({{180, 40}, {0, 60}, {40, 30}});
  EXPECT_EQ(Cut({.min_junction_angle_deg = 39}), 0);
  EXPECT_EQ(Cut({.min_junction_angle_deg = 41}), 1);
}

LIMN_ALL_VARIANTS(CutForksTest);

}  // namespace
}  // namespace limn
