#include <gtest/gtest.h>

#include "limn/drawing/drawing_fixture.h"

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

class CleanUpTest : public DrawingSceneTest {
 protected:
  // Two links that meet alone in a node, with this turn.
  void AddMeeting(double turn_deg) {
    scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
    scene_.AddLink(Path({{0, 0, 0}, Polar(50, turn_deg)}));
    scene_.ShareNode({0, 0, 0});
  }

  // A line along x through a node at the origin.
  void AddCutBar() { AddMeeting(0); }

  void ExpectSamples(const CleanupCounts& counts) {
    EXPECT_EQ(scene_.Look().NumSamples() + counts.samples_pruned + counts.samples_covered,
              scene_.NumSketchSamples());
  }
};

TEST_P(CleanUpTest, SmoothNodeOfTwoDissolves) {
  AddMeeting(28);
  const CleanupCounts counts = scene_.CleanUp();
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

TEST_P(CleanUpTest, SharpNodeOfTwoStays) {
  AddMeeting(32);
  EXPECT_EQ(scene_.CleanUp().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(CleanUpTest, TurnLimitIsAnOption) {
  AddMeeting(40);
  EXPECT_EQ(scene_.CleanUp({.max_continuation_angle_deg = 38}).dissolved_nodes, 0);
  EXPECT_EQ(scene_.CleanUp({.max_continuation_angle_deg = 42}).dissolved_nodes, 1);
}

TEST_P(CleanUpTest, NodeOfThreeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 40, 0}}));
  EXPECT_EQ(scene_.CleanUp().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(CleanUpTest, ChainOfSmoothNodesBecomesOneLink) {
  for (const double x : {-60, 20, -20}) scene_.AddLink(Path({{x, 0, 0}, {x + 40, 0, 0}}));
  scene_.ShareNode({-20, 0, 0});
  scene_.ShareNode({20, 0, 0});
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.dissolved_nodes, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, LinkThatReturnsToItsNodeCloses) {
  scene_.AddLink(Arc({0, 0, 0}, 30, 0, 360));
  scene_.ShareNode({30, 0, 0});
  const CleanupCounts counts = scene_.CleanUp();
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  EXPECT_EQ(picture.NumMeetings(), 0);
  EXPECT_TRUE(picture.LinksAdvance());
  EXPECT_NEAR(picture.LengthPxAt({30, 0, 0}), 2 * M_PI * 30, 0.1);
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, TwoArcsBecomeOneLoop) {
  scene_.AddLink(Arc({0, 0, 0}, 50, 0, 180));
  scene_.AddLink(Arc({0, 0, 0}, 50, 360, 180));
  scene_.ShareNode({50, 0, 0});
  scene_.ShareNode({-50, 0, 0});
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_EQ(scene_.Look().NumClosed(), 1);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, ShortFreeLinksGo) {
  scene_.AddLink(Path({{0, 0, 0}, {13, 0, 0}}));
  scene_.AddLink(Path({{0, 30, 0}, {15, 30, 0}}));
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.samples_pruned, 14);
  EXPECT_EQ(counts.samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 15, 1e-6);
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, ShortestLengthIsAnOption) {
  scene_.AddLink(Path({{0, 0, 0}, {10, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp({.min_link_length_px = 9}).samples_pruned, 0);
  EXPECT_EQ(scene_.CleanUp({.min_link_length_px = 11}).samples_pruned, 11);
  EXPECT_EQ(scene_.Look().NumLinks(), 0);
}

TEST_P(CleanUpTest, ShortHangingLinkGoesAndItsNodeDissolves) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 13, 0}}));
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.samples_pruned, 14);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 100, 1e-6);
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, LongerHangingLinkStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 15, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_pruned, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(CleanUpTest, ShortBridgeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 5, -50}, {0, 5, 0}}));
  scene_.AddLink(Path({{0, 5, 0}, {0, 5, 50}}));
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}));
  scene_.ShareNode({0, 5, 0});
  EXPECT_EQ(scene_.CleanUp().samples_pruned, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 5);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 5, 0}), 3);
}

TEST_P(CleanUpTest, BridgeOfNoLengthGoes) {
  AddCutBar();
  scene_.AddLink(Path({{0, 1, -50}, {0, 1, 0}}));
  scene_.AddLink(Path({{0, 1, 0}, {0, 1, 50}}));
  scene_.AddLink(Path({{0, 0, 0}, {0, 1, 0}}));
  scene_.ShareNode({0, 1, 0});
  EXPECT_EQ(scene_.CleanUp().samples_pruned, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(CleanUpTest, SmallLoopAtANodeIsNoBridge) {
  AddCutBar();
  scene_.AddLink(Arc({0, 2, 0}, 2, -90, 270));
  EXPECT_EQ(scene_.CleanUp().dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(CleanUpTest, ShortGrownLinkAtANodeStays) {
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}), {.grown = true});
  EXPECT_EQ(scene_.CleanUp().dissolved_nodes, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(CleanUpTest, ShortGrownLinkAloneGoes) {
  scene_.AddLink(Path({{0, 0, 0}, {0, 5, 0}}), {.grown = true});
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(scene_.Look().NumLinks(), 0);
  // Its samples are not of the sketch.
  EXPECT_EQ(counts.samples_pruned, 0);
}

TEST_P(CleanUpTest, LinkIsGrownOnlyAsAWhole) {
  // A short grown link fuses with a short one that is not: what hangs at the corner is short.
  AddMeeting(90);
  scene_.AddLink(Path({{0, 0, 0}, {-4, -4, 0}}), {.grown = true});
  scene_.AddLink(Path({{-4, -4, 0}, {-7, -7, 0}}));
  scene_.ShareNode({-4, -4, 0});
  scene_.CleanUp();
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(CleanUpTest, ShortPiecesThatFuseToALongOneStay) {
  scene_.AddLink(Path({{-8, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, 0, 0}, {8, 0, 0}}));
  scene_.ShareNode({0, 0, 0});
  EXPECT_EQ(scene_.CleanUp().samples_pruned, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(CleanUpTest, WhatHangsByShortLinksGoesInTurn) {
  // A stem on the bar bears two twigs. Without them the stem hangs, without it the bar is whole.
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, {0, 10, 0}}));
  scene_.AddLink(Path({{0, 10, 0}, {7, 17, 0}}));
  scene_.AddLink(Path({{0, 10, 0}, {-7, 17, 0}}));
  scene_.ShareNode({0, 10, 0});
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.samples_pruned, scene_.NumSketchSamples() - 2 * 51);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 100, 1e-6);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({50, 0, 0}));
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, ShorterOfTwoThatRunTogetherGoes) {
  scene_.AddLink(Path({{-20, 0.5, 0}, {20, 0.5, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.samples_covered, 41);
  EXPECT_EQ(counts.samples_pruned, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  ExpectSamples(counts);
}

TEST_P(CleanUpTest, OneOfTwoAlikeStays) {
  scene_.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}));
  scene_.AddLink(Path({{-20, 0.5, 0}, {20, 0.5, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 41);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(CleanUpTest, ParallelLinksStay) {
  scene_.AddLink(Path({{-20, 3, 0}, {20, 3, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(CleanUpTest, MergeDistanceIsAnOption) {
  scene_.AddLink(Path({{-20, 0.9, 0}, {20, 0.9, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp({.merge_distance_px = 0.8}).samples_covered, 0);
  EXPECT_EQ(scene_.CleanUp({.merge_distance_px = 1}).samples_covered, 41);
}

TEST_P(CleanUpTest, UncertainDepthCoversFurther) {
  // 1.2 px apart in height, of which the upper link knows its own to 1 px.
  const Eigen::Matrix3d uncertain = Vector3d(100, 100, 1).asDiagonal();
  scene_.AddLink(Path({{-20, 0, 1.2}, {20, 0, 1.2}}), {.information = uncertain});
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 41);
}

TEST_P(CleanUpTest, CertainDepthDoesNot) {
  // Known to 0.1 px.
  scene_.AddLink(Path({{-20, 0, 1.2}, {20, 0, 1.2}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 0);
}

TEST_P(CleanUpTest, LinkThatLeavesTheOtherStays) {
  // Along it for half of its length.
  scene_.AddLink(Path({{-30, 0.5, 0}, {0, 0.5, 0}, {20, 20, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(CleanUpTest, LinkThatTouchesTheOtherOverMostOfItsLengthGoes) {
  // Along it for 40 of 44 px.
  scene_.AddLink(Path({{-40, 0.5, 0}, {0, 0.5, 0}, {3, 3.5, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  EXPECT_GT(scene_.CleanUp().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(CleanUpTest, CrossedLinksStay) {
  // Rungs 1 px apart on which a link across lies: near to all of its points, along none.
  scene_.AddLink(Path({{0, -10, 0}, {0, 10, 0}}));
  for (int y = -10; y <= 10; ++y) scene_.AddLink(Path({{-25, 1.0 * y, 0}, {25, 1.0 * y, 0}}));
  EXPECT_EQ(scene_.CleanUp().samples_covered, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 22);
}

TEST_P(CleanUpTest, ForksAreCutFirst) {
  // The strand that leaves the line by 10 degrees is freed, and the line becomes whole.
  AddCutBar();
  scene_.AddLink(Path({{0, 0, 0}, Polar(40, 10)}));
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.forks_cut, 1);
  EXPECT_EQ(counts.dissolved_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_TRUE(scene_.Look().Covers({{-50, 0, 0}, {50, 0, 0}}, 1e-6));
}

TEST_P(CleanUpTest, TidyDrawingStaysAsItIs) {
  AddMeeting(90);
  scene_.CleanUp();
  const CleanupCounts counts = scene_.CleanUp();
  EXPECT_EQ(counts.forks_cut + counts.dissolved_nodes, 0);
  EXPECT_EQ(counts.samples_covered + counts.samples_pruned, 0);
}

LIMN_ALL_VARIANTS(CleanUpTest);

}  // namespace
}  // namespace limn
