#include "limn/drawing/curve_consistency.h"

#include <numeric>

#include <gtest/gtest.h>

namespace limn {
namespace {

std::vector<double> UnitArc(size_t count) {
  std::vector<double> arc(count);
  std::iota(arc.begin(), arc.end(), 0.0);
  return arc;
}

// Partner 100 + k at every k in [begin, end) of these ranges, -1 elsewhere.
std::vector<int> Partners(size_t count, const std::vector<std::pair<int, int>>& ranges) {
  std::vector<int> partner(count, -1);
  for (const auto& [begin, end] : ranges) {
    for (int k = begin; k < end; ++k) partner[k] = 100 + k;
  }
  return partner;
}

TEST(RegularizeOverlapTest, FillsGapUpToMaxGapByInterpolation) {
  std::vector<int> partner = Partners(60, {{0, 20}, {26, 60}});
  RegularizeOverlap(UnitArc(60), 7, 5, &partner);
  EXPECT_EQ(partner, Partners(60, {{0, 60}}));
}

TEST(RegularizeOverlapTest, InterpolatesDescendingPartners) {
  std::vector<int> partner(40);
  for (int k = 0; k < 40; ++k) partner[k] = 200 - k;
  const std::vector<int> full = partner;
  for (int k = 10; k < 14; ++k) partner[k] = -1;
  RegularizeOverlap(UnitArc(40), 9, 5, &partner);
  EXPECT_EQ(partner, full);
}

TEST(RegularizeOverlapTest, KeepsLongerGap) {
  const std::vector<int> before = Partners(80, {{0, 30}, {45, 80}});
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(80), 9, 5, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, GapIsMeasuredInArcLengthNotSamples) {
  std::vector<double> arc = UnitArc(40);
  for (double& a : arc) a *= 3;
  const std::vector<int> before = Partners(40, {{0, 18}, {22, 40}});  // 15 long, 4 samples
  std::vector<int> partner = before;
  RegularizeOverlap(arc, 9, 5, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, RemovesShortRunInside) {
  std::vector<int> partner = Partners(100, {{0, 30}, {45, 49}, {65, 100}});
  RegularizeOverlap(UnitArc(100), 9, 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{0, 30}, {65, 100}}));
}

TEST(RegularizeOverlapTest, RemovesShortRunsAtBothEnds) {
  std::vector<int> partner = Partners(100, {{0, 4}, {30, 60}, {96, 100}});
  RegularizeOverlap(UnitArc(100), 9, 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{30, 60}}));
}

TEST(RegularizeOverlapTest, DoesNotExtendToTheEnds) {
  const std::vector<int> before = Partners(100, {{3, 97}});
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(100), 9, 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, ShortRunsNearEachOtherJoinBeforeTheyAreJudged) {
  std::vector<int> partner = Partners(100, {{40, 45}, {50, 55}});
  RegularizeOverlap(UnitArc(100), 9, 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{40, 55}}));
}

TEST(RegularizeOverlapTest, LessIsAskedOfShortCurves) {
  const std::vector<int> before = Partners(11, {{3, 10}});  // 6 of 10, but less than 9
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(11), 2, 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, NothingStaysNothing) {
  std::vector<int> partner(20, -1);
  RegularizeOverlap(UnitArc(20), 9, 9, &partner);
  EXPECT_EQ(partner, std::vector<int>(20, -1));
}

}  // namespace
}  // namespace limn
