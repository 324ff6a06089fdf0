// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/merging.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "limn/paper/merging_scene.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::Arc;
using testing::LinkTraits;
using testing::MergingSceneTest;
using testing::Moved;
using testing::Path;
using testing::Picture;
using testing::Polar;
using testing::Ring;

// FitLinks moves points across the curve where a merged curve begins or ends beside them: by no
// more than that was off, half a px in these tests.
constexpr double kNear = 0.5;

class MergeCurvesTest : public MergingSceneTest {
 protected:
  // The longest curve, along x.
  void AddBar() { scene_.AddLink(Path({{-75, 0, 0}, {75, 0, 0}})); }

  void ExpectAllSamplesInLinks() {
    EXPECT_EQ(scene_.Look().NumSamples(), scene_.NumSketchSamples());
  }

  static void ExpectNothingJoined(const MergingCounts& counts) {
    EXPECT_EQ(counts.elongated + counts.branched + counts.bridged, 0);
    EXPECT_EQ(counts.rejoined + counts.multi_attached, 0);
  }
};

TEST_P(MergeCurvesTest, CurvesFarFromEachOtherAreReleased) {
  AddBar();
  scene_.AddLink(Path({{-50, 30, 0}, {50, 30, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 2);
  ExpectNothingJoined(counts);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 150, 1e-3);
  EXPECT_NEAR(picture.LengthPxAt({0, 30, 0}), 100, 1e-3);
  EXPECT_EQ(picture.FreeEnds().size(), 4u);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, CurvesMergeWithinClustersOnly) {
  AddBar();
  scene_.AddLink(Path({{-30, 0.6, 0}, {30, 0.6, 0}}));
  EXPECT_EQ(scene_.Merge().released, 1);
  scene_.PutIntoCluster(1, 1);
  EXPECT_EQ(scene_.Merge().released, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(MergeCurvesTest, CurveAlongALinkIsAbsorbed) {
  AddBar();
  scene_.AddLink(Path({{-30, 0.6, 0}, {30, 0.6, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, CurveBesideALinkIsNot) {
  // At least .77 px in all views.
  AddBar();
  scene_.AddLink(Path({{-30, 0.82, 0}, {30, 0.82, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 2);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(MergeCurvesTest, MergeDistanceIsAnOption) {
  AddBar();
  scene_.AddLink(Path({{-30, 1, 0}, {30, 1, 0}}));
  EXPECT_EQ(scene_.Merge({.merge_distance_px = 0.9}).released, 2);
  EXPECT_EQ(scene_.Merge({.merge_distance_px = 1.1}).released, 1);
}

TEST_P(MergeCurvesTest, DistanceIsThatInTheImages) {
  // 2 px below the other, but seen from 75 degrees above this is at most .54 px.
  AddBar();
  scene_.AddLink(Path({{-30, 0, -2}, {30, 0, -2}}));
  EXPECT_EQ(scene_.Merge().released, 1);
}

TEST_P(MergeCurvesTest, DistantCurvesAreNotCompared) {
  // As above, but 7 px below: no more than the limit of 3 px in the images.
  AddBar();
  scene_.AddLink(Path({{-30, 0, -7}, {30, 0, -7}}));
  EXPECT_EQ(scene_.Merge({.merge_distance_px = 3}).released, 2);
}

TEST_P(MergeCurvesTest, RunBeyondTheEndElongates) {
  AddBar();
  scene_.AddLink(Path({{50, 0.3, 0}, {120, 0.3, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.branched + counts.multi_attached + counts.bridged + counts.rejoined, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 195, kNear);
  EXPECT_TRUE(picture.HasFreeEndAt({-75, 0, 0}, kNear));
  EXPECT_TRUE(picture.HasFreeEndAt({120, 0.3, 0}, kNear));
  EXPECT_TRUE(picture.LinksAdvance());
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunThatLeavesTheInsideBranches) {
  AddBar();
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, {0, 40, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.elongated + counts.multi_attached + counts.bridged + counts.rejoined, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 3);
  ASSERT_EQ(picture.NumMeetings(), 1);
  // At the last sample with the direction of the bar, which is the one before the corner.
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}, 1 + kNear), 3);
  EXPECT_NEAR(picture.LengthPxAt({-40, 0, 0}), 75, 1 + kNear);
  EXPECT_NEAR(picture.LengthPxAt({40, 0, 0}), 75, 1 + kNear);
  EXPECT_NEAR(picture.LengthPxAt({0, 20, 0}), 40, 1 + kNear);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunBetweenTwoLinksBridges) {
  AddBar();
  scene_.AddLink(Path({{-70, 40, 0}, {70, 40, 0}}));
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, {0, 40, 0}, {40, 40, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 2);
  EXPECT_EQ(counts.bridged, 1);
  EXPECT_EQ(counts.branched, 2);
  EXPECT_EQ(counts.elongated + counts.multi_attached + counts.rejoined, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 5);
  EXPECT_EQ(picture.NumMeetings(), 2);
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}, 1 + kNear), 3);
  EXPECT_EQ(picture.DegreeAt({0, 40, 0}, 1 + kNear), 3);
  EXPECT_NEAR(picture.LengthPxAt({0, 20, 0}), 40, 2 + kNear);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunThatReturnsToItsLinkRejoins) {
  AddBar();
  scene_.AddLink(
      Path({{-50, 0, 0}, {-25, 0, 0}, {-15, 10, 0}, {15, 10, 0}, {25, 0, 0}, {50, 0, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched, 2);
  EXPECT_EQ(counts.elongated + counts.multi_attached + counts.bridged, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 4);
  EXPECT_EQ(picture.NumMeetings(), 2);
  EXPECT_EQ(picture.DegreeAt({-25, 0, 0}, 1 + kNear), 3);
  EXPECT_EQ(picture.DegreeAt({25, 0, 0}, 1 + kNear), 3);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 50, 2 + kNear);
  EXPECT_NEAR(picture.LengthPxAt({0, 10, 0}), 30 + 2 * std::hypot(10, 10), 2 + kNear);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, SmallBubbleIsAbsorbed) {
  // Off the bar for 8.5 px of the curve and 6 px of the bar.
  AddBar();
  scene_.AddLink(Path({{-50, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {3, 0, 0}, {50, 0, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, SmallestBubbleIsAnOption) {
  AddBar();
  scene_.AddLink(Path({{-50, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {3, 0, 0}, {50, 0, 0}}));
  EXPECT_EQ(scene_.Merge({.min_branch_length_px = 5}).rejoined, 1);
}

TEST_P(MergeCurvesTest, ArcsAroundALoopCloseIt) {
  scene_.AddLink(Arc({0, 0, 0}, 30, 0, 300));
  scene_.AddLink(Arc({0, 0, 0}, 30, 260, 400));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched + counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  EXPECT_NEAR(picture.LengthPxAt({30, 0, 0}), 2 * M_PI * 30, 1 + kNear);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, ClosedCurveIsAClosedLink) {
  scene_.AddLink(Ring({0, 0, 0}, 30), {.closed = true});
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_EQ(scene_.Look().NumClosed(), 1);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, BranchFromAClosedLinkOpensIt) {
  scene_.AddLink(Ring({0, 0, 0}, 30), {.closed = true});
  auto branch = Arc({0, 0, 0}, 30, 60, 180);
  for (const Vector3d& point : Path({{-30, 0, 0}, {-70, 0, 0}})) {
    if (point.x() < -30) branch.push_back(point);
  }
  scene_.AddLink(branch);
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.branched, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_EQ(picture.NumClosed(), 0);
  EXPECT_EQ(picture.DegreeAt({-30, 0, 0}, 1 + kNear), 3);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunFromTheTipEndsThere) {
  // Leaves 3 px before the end of the bar, at a right angle.
  AddBar();
  scene_.AddLink(Path({{20, 0, 0}, {73, 0, 0}, {73, 40, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.multi_attached, 1);
  EXPECT_EQ(counts.elongated + counts.branched + counts.bridged + counts.rejoined, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  // Between where the run leaves and the tip.
  EXPECT_EQ(picture.DegreeAt({74, 0, 0}, 1 + kNear), 2);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, JunctionDistanceIsAnOption) {
  AddBar();
  scene_.AddLink(Path({{20, 0, 0}, {73, 0, 0}, {73, 40, 0}}));
  const MergingCounts counts = scene_.Merge({.junction_distance_px = 2});
  EXPECT_EQ(counts.multi_attached, 0);
  EXPECT_EQ(counts.branched, 1);
}

TEST_P(MergeCurvesTest, TwoRunsFromOnePlaceShareTheNode) {
  AddBar();
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, {0, 50, 0}}));
  scene_.AddLink(Path({{-35, 0, 0}, {2, 0, 0}, {2, -40, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.multi_attached, 1);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 4);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}, 1 + kNear), 4);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunThatLeavesNearTheEndReplacesTheStub) {
  // 7 px before the end, by 35 degrees.
  AddBar();
  const Vector3d leave(68, 0, 0);
  scene_.AddLink(Path({{0, 0, 0}, leave, leave + Polar(50, 35)}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.branched, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  EXPECT_TRUE(scene_.Look().HasFreeEndAt(leave + Polar(50, 35), kNear));
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, LongestStubIsAnOption) {
  AddBar();
  const Vector3d leave(68, 0, 0);
  scene_.AddLink(Path({{0, 0, 0}, leave, leave + Polar(50, 35)}));
  const MergingCounts counts = scene_.Merge({.min_branch_length_px = 5});
  EXPECT_EQ(counts.elongated, 0);
  EXPECT_EQ(counts.branched, 1);
}

TEST_P(MergeCurvesTest, ShortRunAtTheEndIsAbsorbed) {
  // 3 px beyond the corner.
  AddBar();
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, {0, 3, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, LongerRunAtTheEndIsNot) {
  AddBar();
  scene_.AddLink(Path({{-40, 0, 0}, {0, 0, 0}, {0, 6, 0}}));
  EXPECT_EQ(scene_.Merge().branched, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 3);
}

TEST_P(MergeCurvesTest, ShortRunAmidstIsAbsorbed) {
  // Off by 1 px for two samples.
  AddBar();
  auto points = Path({{-40, 0, 0}, {40, 0, 0}});
  points[40].y() = points[41].y() = 1;
  scene_.AddLink(points);
  const MergingCounts counts = scene_.Merge({.min_branch_length_px = 0});
  EXPECT_EQ(counts.released, 1);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, LongerRunAmidstIsNot) {
  AddBar();
  auto points = Path({{-40, 0, 0}, {40, 0, 0}});
  for (int k = 40; k < 46; ++k) points[k].y() = 1;
  scene_.AddLink(points);
  EXPECT_EQ(scene_.Merge({.min_branch_length_px = 0}).rejoined, 1);
}

TEST_P(MergeCurvesTest, CurveThatReturnsIntoItselfIsASix) {
  // Down the stem, around, and 15 px down the stem again.
  auto six = Path({{0, 80, 0}, {0, 1, 0}});
  const auto loop = Arc({20, 0, 0}, 20, 180, 180 + 360 + 45);
  six.insert(six.end(), loop.begin(), loop.end());
  scene_.AddLink(six);
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("six");
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.elongated + counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_EQ(picture.NumMeetings(), 1);
  // Where the curve is within .7 px of the stem.
  EXPECT_EQ(picture.DegreeAt({0, 5, 0}, 3), 3);
  ASSERT_EQ(picture.FreeEnds().size(), 1u);
  EXPECT_TRUE(picture.HasFreeEndAt({0, 80, 0}, kNear));
  EXPECT_NEAR(picture.LengthPxAt({40, 0, 0}), 2 * M_PI * 20, 5);
  EXPECT_NEAR(picture.LengthPxAt({0, 60, 0}), 75, 4);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, CurveWhoseEndComesUponItsInsideIsAP) {
  scene_.AddLink(Path({{0, 0, 0}, {0, 80, 0}, {40, 80, 0}, {40, 40, 0}, {2, 40, 0}}));
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("p");
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.elongated + counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({0, 40, 0}, 1 + kNear), 3);
  EXPECT_EQ(picture.FreeEnds().size(), 1u);
  EXPECT_NEAR(picture.LengthPxAt({0, 20, 0}), 40, 1 + kNear);
  EXPECT_NEAR(picture.LengthPxAt({40, 60, 0}), 160, 3);  // corners are smoothed
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, CurveThatTurnsBackIsNoLoop) {
  // Half a px beside itself, and with an end 3 px beside it.
  scene_.AddLink(Path({{0, 0, 0}, {80, 0, 0}, {80, 0.5, 0}, {0, 0.5, 0}}));
  scene_.AddLink(Path({{0, 50, 0}, {80, 50, 0}, {80, 53, 0}, {20, 53, 0}}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 2);
  ExpectNothingJoined(counts);
  EXPECT_EQ(scene_.Look().NumLinks(), 2);
}

TEST_P(MergeCurvesTest, CurveAroundALoopClosesWithoutAStub) {
  scene_.AddLink(Arc({0, 0, 0}, 30, 0, 400));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.elongated + counts.branched + counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  EXPECT_NEAR(picture.LengthPxAt({30, 0, 0}), 2 * M_PI * 30, 1 + kNear);
  EXPECT_TRUE(picture.LinksAdvance());
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, EndThatALoopPassesIsCutOff) {
  // The first 7 px of the longer arc leave the circle.
  Polyline3d hooked;
  for (int k = 0; k < 7; ++k) hooked.push_back(Polar(30 + 0.7 * (7 - k), 2 * k));
  const auto arc = Arc({0, 0, 0}, 30, 14, 300);
  hooked.insert(hooked.end(), arc.begin(), arc.end());
  scene_.AddLink(hooked);
  scene_.AddLink(Arc({0, 0, 0}, 30, 260, 400));
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("loop");
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched + counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  ASSERT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.NumClosed(), 1);
  for (const Vector3d& point : picture.links[0].points) EXPECT_NEAR(point.norm(), 30, 2.5);
  EXPECT_TRUE(picture.LinksAdvance());
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RestOfAClosedCurveIsOneRun) {
  // The closed curve begins where no link is.
  scene_.AddLink(Path({{-200, 0, 0}, {200, 0, 0}}));
  scene_.AddLink(
      Path({{0, 60, 0}, {30, 60, 0}, {30, 0, 0}, {-30, 0, 0}, {-30, 60, 0}, {-1, 60, 0}}),
      {.closed = true});
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("bubble");
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched, 2);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 4);
  EXPECT_EQ(picture.FreeEnds().size(), 2u);
  EXPECT_NEAR(picture.LengthPxAt({0, 60, 0}), 180, 4);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, EndsOfABridgeAreDecidedOneByOne) {
  // It elongates one bar and branches from the other.
  AddBar();
  scene_.AddLink(Path({{130, -70, 0}, {130, 70, 0}}));
  scene_.AddLink(Path({{40, 0, 0}, {130, 0, 0}, {130, 30, 0}}));
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("bridge");
  EXPECT_EQ(counts.released, 2);
  EXPECT_EQ(counts.bridged, 1);
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.rejoined + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 3);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({130, 0, 0}, 1 + kNear), 3);
  EXPECT_EQ(picture.FreeEnds().size(), 3u);
  EXPECT_NEAR(picture.LengthPxAt({0, 0, 0}), 205, 2);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunThatElongatesAndRejoinsMakesALollipop) {
  scene_.AddLink(Path({{-75, 0, 0}, {190, 0, 0}}));
  scene_.AddLink(
      Path({{-60, 0, 0}, {-90, 0, 0}, {-90, -30, 0}, {0, -30, 0}, {0, 0, 0}, {40, 0, 0}}));
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("rejoining");
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.elongated, 1);
  EXPECT_EQ(counts.rejoined, 1);
  EXPECT_EQ(counts.branched, 1);
  EXPECT_EQ(counts.bridged + counts.multi_attached, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 2);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({0, 0, 0}, 1 + kNear), 3);
  ASSERT_EQ(picture.FreeEnds().size(), 1u);
  EXPECT_TRUE(picture.HasFreeEndAt({190, 0, 0}, kNear));
  EXPECT_NEAR(picture.LengthPxAt({-50, -30, 0}), 240, 4);
  EXPECT_NEAR(picture.LengthPxAt({150, 0, 0}), 190, 2);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, RunFromTwoLinksMeetsBothInOneNode) {
  // The curve lies between two bars before it leaves them.
  AddBar();
  scene_.AddLink(Path({{-60, 1.1, 0}, {60, 1.1, 0}}));
  scene_.AddLink(Path({{-40, 0.5, 0}, {0, 0.5, 0}, {0, -40, 0}}));
  const MergingCounts counts = scene_.Merge();
  scene_.WritePicture("multi-attachment");
  EXPECT_EQ(counts.released, 2);
  EXPECT_EQ(counts.multi_attached, 1);
  EXPECT_EQ(counts.branched + counts.elongated + counts.bridged + counts.rejoined, 0);
  const Picture picture = scene_.Look();
  EXPECT_EQ(picture.NumLinks(), 5);
  EXPECT_EQ(picture.NumMeetings(), 1);
  EXPECT_EQ(picture.DegreeAt({0, 0.5, 0}, 2), 5);
  EXPECT_EQ(picture.FreeEnds().size(), 5u);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, LinksMoreThanTwiceAsFarAreNotTouched) {
  AddBar();
  scene_.AddLink(Path({{-60, 0.9, 0}, {60, 0.9, 0}}));
  scene_.AddLink(Path({{-40, 0.25, 0}, {0, 0.25, 0}, {0, -40, 0}}));
  EXPECT_EQ(scene_.Merge({.merge_distance_px = 0.8}).branched, 1);
  EXPECT_EQ(scene_.Look().NumLinks(), 4);
  EXPECT_EQ(scene_.Look().DegreeAt({0, 0, 0}, 1 + kNear), 3);
}

TEST_P(MergeCurvesTest, CurvesThatCrossAtALargeAngleHaveNothingInCommon) {
  AddBar();
  scene_.AddLink(Path({Polar(-40, 30), Polar(40, 30)}));
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 2);
  ExpectNothingJoined(counts);
}

TEST_P(MergeCurvesTest, LargestAngleIsAnOption) {
  // With a larger one they share the samples where they cross.
  AddBar();
  scene_.AddLink(Path({Polar(-40, 30), Polar(40, 30)}));
  const MergingCounts counts = scene_.Merge({.max_link_angle_deg = 35});
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.branched + counts.multi_attached, 2);
  ExpectAllSamplesInLinks();
}

TEST_P(MergeCurvesTest, LongestCurveIsFirst) {
  // Were the short one first, the long one would elongate it at both ends.
  scene_.AddLink(Path({{-20, 0.3, 0}, {20, 0.3, 0}}));
  AddBar();
  const MergingCounts counts = scene_.Merge();
  EXPECT_EQ(counts.released, 1);
  EXPECT_EQ(counts.elongated, 0);
  EXPECT_EQ(scene_.Look().NumLinks(), 1);
}

TEST_P(MergeCurvesTest, NetworkDecidesBetweenTwoLinks) {
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  scene_.AddLink(Path({{-60, 1.1, 0}, {60, 1.1, 0}}));
  const int between = scene_.AddLink(Path({{-30, 0.5, 0}, {30, 0.5, 0}}));
  scene_.RunAlong(between, 1);
  EXPECT_EQ(scene_.Merge().released, 2);
  EXPECT_EQ(scene_.Look().LinkAt({50, 0, 0}).num_samples, 121);
  EXPECT_EQ(scene_.Look().LinkAt({50, 1.1, 0}).num_samples, 121 + 61);
}

TEST_P(MergeCurvesTest, WithoutItTheNearerDoes) {
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  scene_.AddLink(Path({{-60, 1.1, 0}, {60, 1.1, 0}}));
  scene_.AddLink(Path({{-30, 0.5, 0}, {30, 0.5, 0}}));
  EXPECT_EQ(scene_.Merge().released, 2);
  EXPECT_EQ(scene_.Look().LinkAt({50, 0, 0}).num_samples, 121 + 61);
}

TEST_P(MergeCurvesTest, NetworkDoesNotJoinWhatTheImagesPart) {
  scene_.AddLink(Path({{-60, 0, 0}, {60, 0, 0}}));
  scene_.AddLink(Path({{-30, 3, 0}, {30, 3, 0}}));
  scene_.RunAlong(1, 0);
  EXPECT_EQ(scene_.Merge().released, 2);
}

TEST_P(MergeCurvesTest, EverySampleIsInOneLink) {
  std::mt19937 random(7);
  testing::UniformDistribution<double> at(-60, 60);
  testing::UniformDistribution<double> wobble(-0.4, 0.4);
  // Streets of a town: curves along one line, then along another.
  for (int i = 0; i < 40; ++i) {
    const double x = 30 * std::round(at(random) / 30);
    const double y = 30 * std::round(at(random) / 30);
    auto points = Path({{at(random), y, 0}, {x, y, 0}, {x, at(random), 0}});
    points = Moved(points, {wobble(random), wobble(random), 0});
    scene_.AddLink(points);
  }
  const MergingCounts counts = scene_.Merge();
  EXPECT_GT(counts.elongated, 0);
  EXPECT_GT(counts.branched, 0);
  ExpectAllSamplesInLinks();
}

LIMN_ALL_VARIANTS(MergeCurvesTest);

class FitLinksTest : public MergingSceneTest {
 protected:
  // The second curve is merged into the first, which is as long.
  Picture Fit(const Vector3d& offset, const Eigen::Matrix3d& first, const Eigen::Matrix3d& second) {
    const auto points = Path({{-30, 0, 0}, {30, 0, 0}});
    scene_.AddLink(points, {.information = first});
    scene_.AddLink(Moved(points, offset), {.information = second});
    EXPECT_EQ(scene_.Merge().released, 1);
    return scene_.Look();
  }
};

TEST_P(FitLinksTest, PointsAreAtTheWeightedMeanOfTheirSamples) {
  const Picture picture =
      Fit({0, 0.4, 0}, 100 * Eigen::Matrix3d::Identity(), 300 * Eigen::Matrix3d::Identity());
  ASSERT_EQ(picture.NumLinks(), 1);
  for (const Vector3d& point : picture.links[0].points) {
    EXPECT_NEAR(point.y(), 0.3, 1e-3);
    EXPECT_NEAR(point.z(), 0, 1e-3);
  }
}

TEST_P(FitLinksTest, EveryDirectionHasItsOwnWeights) {
  const Picture picture =
      Fit({0, 0.4, 0.4}, Vector3d(1, 400, 4).asDiagonal(), Vector3d(1, 4, 400).asDiagonal());
  ASSERT_EQ(picture.NumLinks(), 1);
  for (const Vector3d& point : picture.links[0].points) {
    EXPECT_NEAR(point.y(), 0.4 * 4 / 404, 1e-3);
    EXPECT_NEAR(point.z(), 0.4 * 400 / 404, 1e-3);
  }
}

TEST_P(FitLinksTest, PointsDoNotMoveAlongTheCurve) {
  scene_.AddLink(Path({{-40, 0, 0}, {40, 0, 0}}));
  scene_.AddLink(Path({{-29.6, 0.4, 0}, {30.4, 0.4, 0}}));
  scene_.Merge();
  const Picture picture = scene_.Look();
  ASSERT_EQ(picture.NumLinks(), 1);
  EXPECT_EQ(picture.links[0].points.size(), 81u);
  for (const Vector3d& point : picture.links[0].points) {
    if (std::abs(point.x()) > 20) continue;  // where the shorter one begins the link bends
    EXPECT_NEAR(point.x(), std::round(point.x()), 0.01);
    EXPECT_NEAR(point.y(), 0.2, 0.01);
  }
}

LIMN_ALL_VARIANTS(FitLinksTest);

}  // namespace
}  // namespace limn
