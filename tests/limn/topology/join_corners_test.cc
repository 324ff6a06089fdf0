// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"
#include "limn/topology/join_ends.h"

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

class JoinCornersTest : public DrawingSceneTest {
 protected:
  MeetingCounts Join(const TopologyOptions& options = {}) {
    return scene_.Meet(&JoinCorners, options);
  }

  // A link that comes from this direction and ends `gap_px` before the origin, or beyond it; its
  // edge in the images reaches the origin.
  void AddArm(double from_deg, double gap_px, const Vector3d& offset = Vector3d::Zero()) {
    const int edge = scene_.AddImageCurve(
        Moved(Path({Polar(60, from_deg), Polar(std::min(gap_px, 0.0), from_deg)}), offset));
    scene_.AddLink(Moved(Path({Polar(60, from_deg), Polar(gap_px, from_deg)}), offset),
                   {.image_curve = edge});
  }

  // Draws two lines of an edge that passes from one into the other by an arc.
  void ExpectFillet(double radius) {
    const Polyline3d level = Path({{-60, 0, 0}, {-radius, 0, 0}});
    const Polyline3d arc = Arc({-radius, -radius, 0}, radius, 90, 0);
    const Polyline3d upright = Path({{0, -radius, 0}, {0, -60, 0}});
    Polyline3d edge = level;
    edge.insert(edge.end(), arc.begin() + 1, arc.end());
    edge.insert(edge.end(), upright.begin() + 1, upright.end());
    const int image_curve = scene_.AddImageCurve(edge);
    scene_.AddLink(level, {.image_curve = image_curve});
    scene_.AddLink(upright, {.image_curve = image_curve});
    const MeetingCounts counts = Join();
    EXPECT_EQ(counts.corners, 0);
    EXPECT_EQ(counts.joined, 1);
    EXPECT_EQ(scene_.Look().NumLinks(), 1);
    EXPECT_TRUE(scene_.Look().Covers(edge, 0.3));
    EXPECT_TRUE(scene_.Look().LinksAdvance());
  }

  void ExpectCornerAt(const Vector3d& point, int degree) {
    const Picture picture = scene_.Look();
    EXPECT_EQ(picture.NumMeetings(), 1);
    EXPECT_EQ(picture.DegreeAt(point), degree);
    EXPECT_TRUE(picture.LinksAdvance());
    EXPECT_EQ(picture.NumSamples(), scene_.NumSketchSamples());
  }
};

TEST_P(JoinCornersTest, TwoEndsMeetWhereTheirLinesDo) {
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}));
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.corners, 1);
  EXPECT_EQ(counts.refused, 0);
  ExpectCornerAt({0, 0, 0}, 2);
  EXPECT_NEAR(scene_.Look().LengthPxAt({-30, 0, 0}), 60, 1e-6);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, -30, 0}), 60, 1e-6);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({-60, 0, 0}));
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({0, -60, 0}));
}

// Fillets, of which only the ends are drawn.
TEST_P(JoinCornersTest, AnArcThatImagesShowIsNoCorner) { ExpectFillet(8); }
TEST_P(JoinCornersTest, NorIsOneOfThreePx) { ExpectFillet(3); }

TEST_P(JoinCornersTest, ACornerThatImagesShowIsNoArc) {
  const int edge = scene_.AddImageCurve(Path({{-60, 0, 0}, {0, 0, 0}, {0, -60, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {-5, 0, 0}}), {.image_curve = edge});
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}), {.image_curve = edge});
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
}

TEST_P(JoinCornersTest, RoundedTipsDoNotMoveTheCorner) {
  // Both bend towards each other over their last 1.5 px.
  const int edge = scene_.AddImageCurve(Path({{-60, 0, 0}, {0, 0, 0}, {0, -60, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}, {-3, -0.5, 0}}), {.image_curve = edge});
  scene_.AddLink(Path({{0, -60, 0}, {0, -4, 0}, {-0.5, -3, 0}}), {.image_curve = edge});
  EXPECT_EQ(Join().corners, 1);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}), 2);
}

TEST_P(JoinCornersTest, ThreeEndsMakeOneNode) {
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}));
  scene_.AddLink(Path({{0, 0, -60}, {0, 0, -3}}));
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 3);
}

TEST_P(JoinCornersTest, PositionIsNearestToAllThreeLines) {
  // Squared distances to the lines y = z = 0, x = z = 0 and x = y = 1 add up to the least at
  // (1/2, 1/2, 0).
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}));
  scene_.AddLink(Path({{1, 1, -60}, {1, 1, -3}}));
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0.5, 0.5, 0}, 3);
}

TEST_P(JoinCornersTest, FourEndsOfACrossMakeOneNode) {
  for (const double angle : {0, 180, 90, 270}) AddArm(angle, 4);
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 4);
}

TEST_P(JoinCornersTest, LineThatMissesTheOthersStaysFree) {
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}));
  scene_.AddLink(Path({{0, 9, -60}, {0, 9, -3}}));
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({0, 9, -3}));
}

TEST_P(JoinCornersTest, MissWithinTheLimitMeetsHalfway) {
  AddArm(180, 4);
  AddArm(270, 4, {0, 0, 3.5});
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 1.75}, 2);
}

TEST_P(JoinCornersTest, MissBeyondTheLimitIsNoCorner) {
  AddArm(180, 4);
  AddArm(270, 4, {0, 0, 4.5});
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.corners, 0);
  EXPECT_EQ(counts.refused, 0);
  EXPECT_EQ(scene_.Look().FreeEnds().size(), 4u);
}

TEST_P(JoinCornersTest, MissLimitIsAnOption) {
  AddArm(180, 4);
  AddArm(270, 4, {0, 0, 2.5});
  EXPECT_EQ(Join({.max_junction_miss_px = 2}).corners, 0);
  EXPECT_EQ(Join({.max_junction_miss_px = 3}).corners, 1);
}

TEST_P(JoinCornersTest, GapWithinTheLimitIsClosed) {
  AddArm(180, 11.5);
  AddArm(270, 4);
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
}

TEST_P(JoinCornersTest, GapBeyondTheLimitIsNot) {
  AddArm(180, 12.5);
  AddArm(270, 4);
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.corners, 0);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(JoinCornersTest, GapLimitIsAnOption) {
  AddArm(180, 4);
  AddArm(270, 8);
  EXPECT_EQ(Join({.max_junction_gap_px = 7}).corners, 0);
  EXPECT_EQ(Join({.max_junction_gap_px = 9}).corners, 1);
}

TEST_P(JoinCornersTest, OvershootIsCutAtTheCorner) {
  AddArm(180, -5.5);
  AddArm(270, -2.5);
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
  EXPECT_NEAR(scene_.Look().LengthPxAt({-30, 0, 0}), 60, 1e-6);
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, -30, 0}), 60, 1e-6);
}

TEST_P(JoinCornersTest, LinesThatCrossFarFromTheirEndsAreNoCorner) {
  AddArm(180, -6.5);
  AddArm(270, -2.5);
  EXPECT_EQ(Join().corners, 0);
}

TEST_P(JoinCornersTest, EndsThatContinueEachOtherAreNoCorner) {
  AddArm(180, 4);
  AddArm(28, 4);
  EXPECT_EQ(Join().corners, 0);
}

TEST_P(JoinCornersTest, SharpTurnIsACorner) {
  AddArm(180, 4);
  AddArm(32, 4);
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
}

TEST_P(JoinCornersTest, EndsSideBySideAreNoCorner) {
  AddArm(180, 4);
  AddArm(152, 4);
  EXPECT_EQ(Join().corners, 0);
}

TEST_P(JoinCornersTest, AngleLimitIsAnOption) {
  AddArm(180, 4);
  AddArm(40, 4);
  EXPECT_EQ(Join({.max_continuation_angle_deg = 42}).corners, 0);
  EXPECT_EQ(Join({.max_continuation_angle_deg = 38}).corners, 1);
}

TEST_P(JoinCornersTest, ImagesMustShowThatTheLinksMeet) {
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}), {.views = {0, 1, 2, 3}});
  scene_.AddLink(Path({{0, -60, 0}, {0, -4, 0}}), {.views = {2, 3, 4, 5}});
  MeetingCounts counts = Join();
  EXPECT_EQ(counts.corners, 0);
  EXPECT_EQ(counts.refused, 1);
  EXPECT_EQ(scene_.Look().FreeEnds().size(), 4u);
  counts = Join({.min_junction_views = 2});
  EXPECT_EQ(counts.corners, 1);
  EXPECT_EQ(counts.refused, 0);
}

TEST_P(JoinCornersTest, EdgesMustReachTheCornerInTheImages) {
  // They end 8 px before it, in all views.
  scene_.AddLink(Path({{-60, 0, 0}, {-8, 0, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -8, 0}}));
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.corners, 0);
  EXPECT_EQ(counts.refused, 1);
}

TEST_P(JoinCornersTest, NearestCornerIsTakenFirst) {
  // The line along x meets the others at x = 1 and x = 11; no point is near to all three.
  const int edge = scene_.AddImageCurve(Path({{-60, 0, 0}, {11, 0, 0}}));
  const int far_edge = scene_.AddImageCurve(Path({{11, -60, 0}, {11, 0, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {0, 0, 0}}), {.image_curve = edge});
  scene_.AddLink(Path({{11, -60, 0}, {11, -1, 0}}), {.image_curve = far_edge});
  scene_.AddLink(Path({{1, -60, 0}, {1, -2, 0}}));
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({1, 0, 0}, 2);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({11, -1, 0}));
}

TEST_P(JoinCornersTest, EndsOfOneLinkNeverMeet) {
  // A drop: leaves the origin along x and returns to it along y.
  scene_.AddLink(Path({{4, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}, {0, 4, 0}}));
  EXPECT_EQ(Join().corners, 0);
  EXPECT_EQ(scene_.Look().FreeEnds().size(), 2u);
}

TEST_P(JoinCornersTest, EndsOfOneLinkNeverMeetByWayOfAnother) {
  scene_.AddLink(Path({{4, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}, {0, 4, 0}}));
  scene_.AddLink(Path({{0, 0, -60}, {0, 0, -3}}));
  EXPECT_EQ(Join().corners, 1);
  ExpectCornerAt({0, 0, 0}, 2);
}

TEST_P(JoinCornersTest, EndsAtNodesAreNotAsked) {
  scene_.AddLink(Path({{-60, 0, 0}, {-4, 0, 0}}));
  scene_.AddLink(Path({{-4, 0, 0}, {-4, 60, 0}}));
  scene_.AddLink(Path({{0, -60, 0}, {0, -5, 0}}));
  scene_.ShareNode({-4, 0, 0});
  EXPECT_EQ(Join().corners, 0);
}

LIMN_ALL_VARIANTS(JoinCornersTest);

}  // namespace
}  // namespace limn
