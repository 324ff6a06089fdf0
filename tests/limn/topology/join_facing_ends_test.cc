// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"
#include "limn/topology/join_ends.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::Arc;
using testing::DrawingScene;
using testing::DrawingSceneTest;
using testing::LinkTraits;
using testing::Moved;
using testing::Path;
using testing::Picture;
using testing::Polar;

// Two views see both of the links with these traits.
const LinkTraits kSeenBySome = {.views = {0, 1, 2, 3}};
const LinkTraits kSeenByOthers = {.views = {2, 3, 4, 5}};

class JoinFacingEndsTest : public DrawingSceneTest {
 protected:
  MeetingCounts Join(const TopologyOptions& options = {}) {
    return scene_.Meet(&JoinFacingEnds, options);
  }

  // Two links along x with this gap between them, the second off the line of the first by `miss`,
  // on one edge of all images.
  void AddFacing(double gap_px, double miss_px = 0) {
    const LinkTraits on_edge = {.image_curve =
                                    scene_.AddImageCurve(Path({{-60, 0, 0}, {60, 0, 0}}))};
    scene_.AddLink(Path({{-60, 0, 0}, {-gap_px / 2, 0, 0}}), on_edge);
    scene_.AddLink(Path({{gap_px / 2, miss_px, 0}, {60, miss_px, 0}}), on_edge);
  }

  // The second link turns away from the direction of the first by this angle.
  void AddTurning(double turn_deg) {
    scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
    scene_.AddLink(Path({Polar(2, turn_deg), Polar(50, turn_deg)}));
  }

  // The second link begins 10 px ahead and 3.8 px beside, and turns by this angle.
  void AddAside(double turn_deg) {
    const LinkTraits on_edge = {.image_curve =
                                    scene_.AddImageCurve(Path({{-60, 0, 0}, {60, 0, 0}}))};
    const Vector3d start(10, 3.8, 0);
    scene_.AddLink(Path({{-60, 0, 0}, {0, 0, 0}}), on_edge);
    scene_.AddLink(Path({start, start + Polar(50, turn_deg)}), on_edge);
  }

  // Expects that the two links became one from end to end, without loss of samples.
  void ExpectJoined() {
    const Picture picture = scene_.Look();
    EXPECT_EQ(picture.NumLinks(), 1);
    EXPECT_EQ(picture.FreeEnds().size(), 2u);
    EXPECT_EQ(picture.NumMeetings(), 0);
    EXPECT_EQ(picture.NumSamples(), scene_.NumSketchSamples());
    EXPECT_TRUE(picture.LinksAdvance());
  }

  void ExpectApart() {
    const Picture picture = scene_.Look();
    EXPECT_EQ(picture.NumLinks(), 2);
    EXPECT_EQ(picture.FreeEnds().size(), 4u);
  }
};

TEST_P(JoinFacingEndsTest, GapWithinTheLimitIsClosed) {
  AddFacing(11.5);
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.joined, 1);
  EXPECT_EQ(counts.refused, 0);
  ExpectJoined();
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({-60, 0, 0}));
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({60, 0, 0}));
}

TEST_P(JoinFacingEndsTest, GapBeyondTheLimitStays) {
  AddFacing(12.5);
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.joined, 0);
  EXPECT_EQ(counts.refused, 0);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, GapLimitIsAnOption) {
  AddFacing(12.5);
  EXPECT_EQ(Join({.max_junction_gap_px = 12}).joined, 0);
  EXPECT_EQ(Join({.max_junction_gap_px = 13}).joined, 1);
}

TEST_P(JoinFacingEndsTest, MissWithinTheLimitIsAccepted) {
  AddFacing(5, 3.5);
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
}

TEST_P(JoinFacingEndsTest, MissBeyondTheLimitIsNot) {
  AddFacing(5, 4.5);
  const MeetingCounts counts = Join();
  EXPECT_EQ(counts.joined, 0);
  EXPECT_EQ(counts.refused, 0);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, MissLimitIsAnOption) {
  AddFacing(5, 2.5);
  EXPECT_EQ(Join({.max_junction_miss_px = 2}).joined, 0);
  EXPECT_EQ(Join({.max_junction_miss_px = 3}).joined, 1);
}

// At -25 degrees the line of the second link passes 7.7 px beside the end of the first, at 25
// degrees .8 px; the second link begins within reach of the first one's line in either case.
TEST_P(JoinFacingEndsTest, LineThatMissesTheOtherEndIsNoContinuation) {
  AddAside(-25);
  EXPECT_EQ(Join().joined, 0);
}

TEST_P(JoinFacingEndsTest, LineThatMeetsTheOtherEndIs) {
  AddAside(25);
  EXPECT_EQ(Join().joined, 1);
}

TEST_P(JoinFacingEndsTest, TurnWithinTheLimitIsAccepted) {
  AddTurning(28);
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
}

TEST_P(JoinFacingEndsTest, TurnBeyondTheLimitIsNot) {
  AddTurning(32);
  EXPECT_EQ(Join().joined, 0);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, TurnLimitIsAnOption) {
  AddTurning(20);
  EXPECT_EQ(Join({.max_continuation_angle_deg = 18}).joined, 0);
  EXPECT_EQ(Join({.max_continuation_angle_deg = 22}).joined, 1);
}

TEST_P(JoinFacingEndsTest, LinksSideBySideDoNotContinue) {
  scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{-50, 2, 0}, {0, 2, 0}}));
  EXPECT_EQ(Join().joined, 0);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, LargerGapNeedsTheImages) {
  // Two views in common, three are asked for.
  scene_.AddLink(Path({{-50, 0, 0}, {-1.75, 0, 0}}), kSeenBySome);
  scene_.AddLink(Path({{1.75, 0, 0}, {50, 0, 0}}), kSeenByOthers);
  MeetingCounts counts = Join();
  EXPECT_EQ(counts.joined, 0);
  EXPECT_EQ(counts.refused, 1);
  ExpectApart();
  counts = Join({.min_junction_views = 2});
  EXPECT_EQ(counts.joined, 1);
  EXPECT_EQ(counts.refused, 0);
  ExpectJoined();
}

TEST_P(JoinFacingEndsTest, ThreeViewsAreEnough) {
  scene_.AddLink(Path({{-50, 0, 0}, {-1.75, 0, 0}}), kSeenBySome);
  scene_.AddLink(Path({{1.75, 0, 0}, {50, 0, 0}}), {.views = {1, 2, 3, 4}});
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
}

TEST_P(JoinFacingEndsTest, SmallGapNeedsNoImages) {
  scene_.AddLink(Path({{-50, 0, 0}, {-1.25, 0, 0}}), {.views = {0, 1, 2, 3}});
  scene_.AddLink(Path({{1.25, 0, 0}, {50, 0, 0}}), {.views = {4, 5, 6, 7}});
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
}

TEST_P(JoinFacingEndsTest, ImageCurvesMustComeNearTheGap) {
  // All views see both, but their edges end 7 px from the middle of the gap.
  scene_.AddLink(Path({{-50, 0, 0}, {-7, 0, 0}}));
  scene_.AddLink(Path({{7, 0, 0}, {50, 0, 0}}));
  const MeetingCounts counts = Join({.max_junction_gap_px = 15});
  EXPECT_EQ(counts.joined, 0);
  EXPECT_EQ(counts.refused, 1);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, SmallestGapIsClosedFirst) {
  scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{8, 0, 0}, {50, 0, 0}}));
  scene_.AddLink(Path({Polar(4, 8), Polar(50, 8)}));
  EXPECT_EQ(Join().joined, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_TRUE(picture.Covers({{-50, 0, 0}, Polar(4, 8), Polar(50, 8)}, 1e-6));
  EXPECT_TRUE(picture.HasFreeEndAt({8, 0, 0}));
}

TEST_P(JoinFacingEndsTest, ChainOfThreeBecomesOneLink) {
  scene_.AddLink(Path({{20, 0, 0}, {60, 0, 0}}));
  scene_.AddLink(Path({{-60, 0, 0}, {-20, 0, 0}}));
  scene_.AddLink(Path({{-18, 0, 0}, {18, 0, 0}}));
  EXPECT_EQ(Join().joined, 2);
  ExpectJoined();
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 120, 1e-6);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({-60, 0, 0}));
  EXPECT_TRUE(scene_.Look().HasFreeEndAt({60, 0, 0}));
}

TEST_P(JoinFacingEndsTest, RingOfArcsCloses) {
  // Gaps of 2.4 degrees, 2.1 px.
  for (const double begin : {180, 0, 90, 270}) {
    scene_.AddLink(Arc({0, 0, 0}, 50, begin + 1.2, begin + 88.8));
  }
  EXPECT_EQ(Join().joined, 4);
  const Picture picture = scene_.Look();
  ASSERT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  EXPECT_TRUE(picture.LinksAdvance());
  EXPECT_EQ(picture.NumSamples(), scene_.NumSketchSamples());
  // Chords of 2.1 px at most are shorter than their arcs by less than a thousandth.
  EXPECT_NEAR(picture.LengthPxAt({50, 0, 0}), 2 * M_PI * 50, 0.2);
}

TEST_P(JoinFacingEndsTest, LinkThatReturnsToItsBeginningCloses) {
  scene_.AddLink(Arc({0, 0, 0}, 50, 1.2, 358.8));
  EXPECT_EQ(Join().joined, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_EQ(scene_.Look().NumClosed(), 1);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
}

TEST_P(JoinFacingEndsTest, OverlapOfARingIsTrimmed) {
  scene_.AddLink(Arc({0, 0, 0}, 50, 1.2, 364));
  EXPECT_EQ(Join().joined, 1);
  EXPECT_EQ(scene_.Look().NumClosed(), 1);
  EXPECT_TRUE(scene_.Look().LinksAdvance());
}

// Its two ends face each other over a gap of minus its length.
TEST_P(JoinFacingEndsTest, ShortStraightLinkDoesNotCloseOnItself) {
  scene_.AddLink(Path({{-2.5, 0, 0}, {2.5, 0, 0}}));
  EXPECT_EQ(Join().joined, 0);
  EXPECT_EQ(scene_.Look().NumClosed(), 0);
}

TEST_P(JoinFacingEndsTest, OvershootIsTrimmed) {
  scene_.AddLink(Path({{-50, 0, 0}, {3, 0, 0}}));
  scene_.AddLink(Path({{-2, 0.3, 0}, {50, 0.3, 0}}));
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
  EXPECT_NEAR(scene_.Look().LengthPxAt({0, 0, 0}), 100, 0.1);
}

TEST_P(JoinFacingEndsTest, LongOverlapIsNoContinuation) {
  scene_.AddLink(Path({{-50, 0, 0}, {3.5, 0, 0}}));
  scene_.AddLink(Path({{-3.5, 0.3, 0}, {50, 0.3, 0}}));
  EXPECT_EQ(Join().joined, 0);
  ExpectApart();
}

TEST_P(JoinFacingEndsTest, EndsAtOnePlaceAreNotDoubled) {
  scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{0, 0, 0}, {50, 0, 0}}));
  EXPECT_EQ(Join().joined, 1);
  ExpectJoined();
  EXPECT_EQ(scene_.Look().LinkAt({0, 0, 0}).points.size(), 101u);
}

TEST_P(JoinFacingEndsTest, EndsAtNodesStayAndFarNodesAreKept) {
  scene_.AddLink(Path({{-50, 0, 0}, {0, 0, 0}}));
  scene_.AddLink(Path({{2, 0, 0}, {50, 0, 0}}));
  scene_.AddLink(Path({{50, 0, 0}, {50, 40, 0}}));
  scene_.AddLink(Path({{-50, 0, 0}, {-50, 40, 0}}));
  scene_.AddLink(Path({{-52, 0, 0}, {-90, 0, 0}}));  // faces a node
  scene_.ShareNode({50, 0, 0});
  scene_.ShareNode({-50, 0, 0});
  EXPECT_EQ(Join().joined, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 4);
  EXPECT_EQ(picture.DegreeAt({50, 0, 0}), 2);
  EXPECT_EQ(picture.DegreeAt({-50, 0, 0}), 2);
  EXPECT_TRUE(picture.HasFreeEndAt({-52, 0, 0}));
}

LIMN_ALL_VARIANTS(JoinFacingEndsTest);

}  // namespace
}  // namespace limn
