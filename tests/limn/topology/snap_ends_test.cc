// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/snap_ends.h"

#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"

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
using testing::Ring;

class SnapEndsTest : public DrawingSceneTest {
 protected:
  // A link that comes from this direction and ends `gap_px` before a point, or beyond it; its edge
  // in the images reaches the point.
  void AddArm(const Vector3d& point, double from_deg, double gap_px, double length_px = 60) {
    const int edge = scene_.AddImageCurve(
        Moved(Path({Polar(length_px, from_deg), Polar(std::min(gap_px, 0.0), from_deg)}), point));
    scene_.AddLink(Moved(Path({Polar(length_px, from_deg), Polar(gap_px, from_deg)}), point),
                   {.image_curve = edge});
  }

  void ExpectSound() {
    const Picture picture = scene_.Look();
    EXPECT_TRUE(picture.LinksAdvance());
    EXPECT_EQ(picture.NumSamples(), scene_.NumSketchSamples());
  }
};

class SnapToNodesTest : public SnapEndsTest {
 protected:
  MeetingCounts Snap(const TopologyOptions& options = {}) {
    return scene_.Meet(&SnapEnds, options);
  }

  // Two links that meet in a node, at a right angle.
  void AddCornerAt(const Vector3d& point, const LinkTraits& traits = {}) {
    scene_.AddLink(Moved(Path({{-60, 0, 0}, {0, 0, 0}}), point), traits);
    scene_.AddLink(Moved(Path({{0, -60, 0}, {0, 0, 0}}), point), traits);
    scene_.ShareNode(point);
  }
};

TEST_P(SnapToNodesTest, EndWithinReachEndsAtTheNode) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 0}, 45, 11.5);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.refused, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_NEAR(scene_.Look().LengthPxAt(Polar(30, 45)), 60, 1e-6);
  ExpectSound();
}

TEST_P(SnapToNodesTest, EndBeyondReachStaysFree) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 0}, 45, 12.5);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_nodes, 0);
  EXPECT_EQ(counts.refused, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(SnapToNodesTest, GapLimitIsAnOption) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 0}, 45, 8);
  EXPECT_EQ(Snap({.max_junction_gap_px = 7}).to_nodes, 0);
  EXPECT_EQ(Snap({.max_junction_gap_px = 9}).to_nodes, 1);
}

TEST_P(SnapToNodesTest, LineThatPassesTheNodeNearlyEndsThere) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 3.5}, 45, 4);
  EXPECT_EQ(Snap().to_nodes, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  ExpectSound();
}

TEST_P(SnapToNodesTest, LineThatMissesTheNodeStaysFree) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 4.5}, 45, 4);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_nodes, 0);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(SnapToNodesTest, MissLimitIsAnOption) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 2.5}, 45, 4);
  EXPECT_EQ(Snap({.max_junction_miss_px = 2}).to_nodes, 0);
  EXPECT_EQ(Snap({.max_junction_miss_px = 3}).to_nodes, 1);
}

TEST_P(SnapToNodesTest, OvershootIsCutAtTheNode) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 0}, 45, -5.5);
  EXPECT_EQ(Snap().to_nodes, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_NEAR(scene_.Look().LengthPxAt(Polar(30, 45)), 60, 1e-6);
  ExpectSound();
}

TEST_P(SnapToNodesTest, LinkThatGoesOnIsNotCutBack) {
  // From above: the links of the corner are far from its end.
  AddCornerAt({0, 0, 0});
  scene_.AddLink(Path({{0, 0, 60}, {0, 0, -6.5}}));
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_nodes + counts.to_links, 0);
}

TEST_P(SnapToNodesTest, ImagesMustShowIt) {
  AddCornerAt({0, 0, 0}, {.views = {0, 1, 2, 3}});
  scene_.AddLink(Path({Polar(60, 45), Polar(4, 45)}), {.views = {2, 3, 4, 5}});
  MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_nodes, 0);
  EXPECT_EQ(counts.refused, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
  counts = Snap({.min_junction_views = 2});
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(SnapToNodesTest, OneLinkOfTheNodeIsEnough) {
  scene_.AddLink(Path({{-60, 0, 0}, {0, 0, 0}}), {.views = {6, 7}});
  scene_.AddLink(Path({{0, -60, 0}, {0, 0, 0}}), {.views = {0, 1, 2}});
  scene_.ShareNode({0, 0, 0});
  scene_.AddLink(Path({Polar(60, 45), Polar(4, 45)}), {.views = {0, 1, 2}});
  EXPECT_EQ(Snap().to_nodes, 1);
}

TEST_P(SnapToNodesTest, NearestNodeWins) {
  AddCornerAt({0, 0, 0});
  AddCornerAt({4, 4, 0});
  AddArm({4, 4, 0}, 45, 4);
  EXPECT_EQ(Snap().to_nodes, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({4, 4, 0}), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(SnapToNodesTest, NearestNodeWinsWhicheverCameFirst) {
  AddCornerAt({4, 4, 0});
  AddCornerAt({0, 0, 0});
  AddArm({4, 4, 0}, 45, 4);
  EXPECT_EQ(Snap().to_nodes, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({4, 4, 0}), 3);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(SnapToNodesTest, ManyEndsMayJoinOneNode) {
  AddCornerAt({0, 0, 0});
  AddArm({0, 0, 0}, 30, 4);
  AddArm({0, 0, 0}, 80, 6);
  EXPECT_EQ(Snap().to_nodes, 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 4);
  ExpectSound();
}

TEST_P(SnapToNodesTest, ShortHookDoesNotReturnToItsOwnNode) {
  // 32 px long; its last 12 px point back to where it begins, 5 px away.
  AddCornerAt({0, 0, 0});
  scene_.AddLink(Path({{0, 0, 0}, {12, 5, 0}, Polar(17, 45), Polar(5, 45)}));
  EXPECT_EQ(Snap().to_nodes, 0);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
}

TEST_P(SnapToNodesTest, LongLoopMayReturnToItsOwnNode) {
  scene_.AddLink(Path({{-60, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}, {0, 4, 0}}));
  scene_.ShareNode({0, 0, 0});
  EXPECT_EQ(Snap().to_nodes, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 4);
}

LIMN_ALL_VARIANTS(SnapToNodesTest);

class SnapToLinksTest : public SnapEndsTest {
 protected:
  MeetingCounts Snap(const TopologyOptions& options = {}) {
    return scene_.Meet(&SnapEnds, options);
  }

  void AddBar(const LinkTraits& traits = {}) {
    scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}), traits);
  }
};

TEST_P(SnapToLinksTest, EndThatMeetsALinkCutsItThere) {
  AddBar();
  AddArm({20, 0, 0}, 90, 11.5);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_links, 1);
  EXPECT_EQ(counts.refused, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 3);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({20, 0, 0}), 3);
  EXPECT_NEAR(picture.LengthPxAt({-30, 0, 0}), 80, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({40, 0, 0}), 40, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({20, 30, 0}), 60, 1e-6);
  EXPECT_EQ(picture.FreeEnds().size(), 3u);
  ExpectSound();
}

TEST_P(SnapToLinksTest, EndBeyondReachDoesNot) {
  AddBar();
  AddArm({0, 0, 0}, 90, 12.5);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(counts.refused, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(SnapToLinksTest, GapLimitIsAnOption) {
  AddBar();
  AddArm({0, 0, 0}, 90, 8);
  EXPECT_EQ(Snap({.max_junction_gap_px = 7}).to_links, 0);
  EXPECT_EQ(Snap({.max_junction_gap_px = 9}).to_links, 1);
}

TEST_P(SnapToLinksTest, LineThatPassesNearlyIsTaken) {
  AddBar();
  AddArm({0, 0, 3.5}, 90, 4);
  EXPECT_EQ(Snap().to_links, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  ExpectSound();
}

TEST_P(SnapToLinksTest, LineThatPassesAboveIsNot) {
  AddBar();
  AddArm({0, 0, 4.5}, 90, 4);
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(SnapToLinksTest, MissLimitIsAnOption) {
  AddBar();
  AddArm({0, 0, 2.5}, 90, 4);
  EXPECT_EQ(Snap({.max_junction_miss_px = 2}).to_links, 0);
  EXPECT_EQ(Snap({.max_junction_miss_px = 3}).to_links, 1);
}

TEST_P(SnapToLinksTest, OvershootIsCut) {
  AddBar();
  AddArm({0, 0, 0}, 90, -5.5);
  EXPECT_EQ(Snap().to_links, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 30, 0}), 60, 1e-6);
  ExpectSound();
}

TEST_P(SnapToLinksTest, LinkThatCrossesGoesOn) {
  AddBar();
  AddArm({0, 0, 0}, 90, -6.5);
  EXPECT_EQ(Snap().to_links, 0);
}

TEST_P(SnapToLinksTest, ImagesMustShowIt) {
  AddBar({.views = {0, 1, 2, 3}});
  scene_.AddLink(Path({{0, 60, 0}, {0, 4, 0}}), {.views = {2, 3, 4, 5}});
  MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(counts.refused, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  counts = Snap({.min_junction_views = 2});
  EXPECT_EQ(counts.to_links, 1);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(SnapToLinksTest, EdgeMustReachTheLinkInTheImages) {
  AddBar();
  scene_.AddLink(Path({{0, 60, 0}, {0, 8, 0}}));
  const MeetingCounts counts = Snap();
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(counts.refused, 1);
}

TEST_P(SnapToLinksTest, TangentApproachIsNoJunction) {
  AddBar();
  AddArm({0, 0, 0}, 23, 4);
  EXPECT_EQ(Snap().to_links, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(SnapToLinksTest, SteeperApproachIs) {
  AddBar();
  AddArm({0, 0, 0}, 27, 4);
  EXPECT_EQ(Snap().to_links, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 3);
}

TEST_P(SnapToLinksTest, AngleLimitIsAnOption) {
  AddBar();
  AddArm({0, 0, 0}, 40, 4);
  EXPECT_EQ(Snap({.min_junction_angle_deg = 42}).to_links, 0);
  EXPECT_EQ(Snap({.min_junction_angle_deg = 38}).to_links, 1);
}

TEST_P(SnapToLinksTest, NearestOfTwoLinksIsCut) {
  scene_.AddLink(Path({{-60, -5, 0}, {60, -5, 0}}));
  AddBar();
  AddArm({0, 0, 0}, 90, 4);
  EXPECT_EQ(Snap().to_links, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 3);
  EXPECT_EQ(scene_.Look().NumMeetings(), 1);
}

TEST_P(SnapToLinksTest, LinkIsNotCutByItself) {
  // A six: the tip meets the stem.
  scene_.AddLink(Path({{-60, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}, {0, 4, 0}}));
  EXPECT_EQ(Snap().to_links, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(SnapToLinksTest, EndOfALinkIsNotItsInside) {
  // But free ends are nodes like others.
  scene_.AddLink(Path({{0, 0, 0}, {60, 0, 0}}));
  scene_.AddLink(Path({{0, 60, 0}, {0, 4, 0}}));
  const MeetingCounts counts = Snap({.max_junction_miss_px = 0.5});
  EXPECT_EQ(counts.to_links, 0);
  EXPECT_EQ(counts.to_nodes, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
  ExpectSound();
}

TEST_P(SnapToLinksTest, TwoFromBothSidesCutALinkInThree) {
  AddBar();
  AddArm({-20, 0, 0}, 90, 4);
  AddArm({25, 0, 0}, 270, 4);
  EXPECT_EQ(Snap().to_links, 2);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 5);
  EXPECT_EQ(picture.NumMeetings(), 2);
  EXPECT_EQ(picture.DegreeAt({-20, 0, 0}), 3);
  EXPECT_EQ(picture.DegreeAt({25, 0, 0}), 3);
  EXPECT_NEAR(picture.LengthPxAt({-40, 0, 0}), 40, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 45, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({40, 0, 0}), 35, 1e-6);
  ExpectSound();
}

TEST_P(SnapToLinksTest, TwoAtOnePlaceMakeOneNode) {
  AddBar();
  AddArm({0, 0, 0}, 90, 4);
  AddArm({0, 0, 0}, 270, 4);
  EXPECT_EQ(Snap().to_links, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 4);
  EXPECT_EQ(scene_.Look().NumMeetings(), 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 4);
  ExpectSound();
}

TEST_P(SnapToLinksTest, LoopBeginsAndEndsAtItsJunction) {
  scene_.AddLink(Ring({0, 0, 0}, 30), {.closed = true});
  AddArm({0, 30, 0}, 90, 4);
  EXPECT_EQ(Snap().to_links, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_EQ(picture.NumClosed(), 0);
  // Points of the ring are 1 px apart.
  EXPECT_EQ(picture.DegreeAt({0, 30, 0}, 0.6), 3);
  EXPECT_NEAR(picture.LengthPxAt({0, -30, 0}), 2 * M_PI * 30, 0.1);
  EXPECT_TRUE(picture.HasFreeEndAt({0, 90, 0}));
  ExpectSound();
}

// The first opens it, and the others cut it the next time.
TEST_P(SnapToLinksTest, ThreeCutALoopInThree) {
  scene_.AddLink(Ring({0, 0, 0}, 30), {.closed = true});
  for (const double angle : {60, 180, 300}) AddArm(Polar(30, angle), angle, 4);
  EXPECT_EQ(Snap().to_links, 1);
  EXPECT_EQ(Snap().to_links, 2);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 6);
  EXPECT_EQ(picture.NumMeetings(), 3);
  for (const double angle : {60, 180, 300}) {
    EXPECT_EQ(picture.DegreeAt(Polar(30, angle), 0.6), 3) << angle;
    EXPECT_NEAR(picture.LengthPxAt(Polar(30, angle + 60)), 2 * M_PI * 10, 1.2) << angle;
  }
  ExpectSound();
}

TEST_P(SnapToLinksTest, LinkThatEndsAtOneAndIsCutByAnother) {
  // The post ends at the bar, whichever of its ends that is, and a rung ends at the post.
  AddBar();
  AddArm({0, 0, 0}, 90, 4, 80);
  AddArm({0, 40, 0}, 0, 4);
  EXPECT_EQ(Snap().to_links, 2);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 5);
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}), 3);
  EXPECT_EQ(picture.DegreeAt({0, 40, 0}), 3);
  EXPECT_NEAR(picture.LengthPxAt({0, 20, 0}), 40, 1e-6);
  EXPECT_NEAR(picture.LengthPxAt({0, 60, 0}), 40, 1e-6);
  EXPECT_TRUE(picture.HasFreeEndAt({0, 80, 0}));
  ExpectSound();
}

TEST_P(SnapToLinksTest, LinkThatEndsAtOneAndIsCutByTwo) {
  AddBar();
  AddArm({0, 0, 0}, 90, 4, 80);
  AddArm({0, 30, 0}, 0, 4);
  AddArm({0, 50, 0}, 180, 4);
  EXPECT_EQ(Snap().to_links, 3);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 7);
  for (const double y : {0, 30, 50}) EXPECT_EQ(picture.DegreeAt({0, y, 0}), 3) << y;
  EXPECT_TRUE(picture.HasFreeEndAt({0, 80, 0}));
  ExpectSound();
}

LIMN_ALL_VARIANTS(SnapToLinksTest);

}  // namespace
}  // namespace limn
