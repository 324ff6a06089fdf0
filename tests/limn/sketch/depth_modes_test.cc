// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/depth_modes.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// `count` vertices 2 px apart.
FragmentRays Spaced(int count) {
  FragmentRays fragment;
  for (int i = 0; i < count; ++i) fragment.arc_px.push_back(2.0 * i);
  return fragment;
}

DepthMode Mode(double inverse_depth, double score, double slope_per_px = 0) {
  DepthMode mode;
  mode.score = score;
  mode.depth.inverse_depth = inverse_depth;
  mode.depth.slope_per_px = slope_per_px;
  mode.depth.px_per_inverse_depth = 1000;
  return mode;
}

TEST(DepthModesTest, SmoothCourseBeatsAccidentalSupport) {
  // One vertex has a little more support for a wrong depth 50 px off.
  std::vector<std::vector<DepthMode>> modes(21, {Mode(0.2, 8)});
  modes[10].push_back(Mode(0.25, 9));
  EXPECT_EQ(ChooseModes(Spaced(21), modes), std::vector<int>(21, 0));
}

TEST(DepthModesTest, SlopeExplainsASlantedCurve) {
  // The slanted one moves by 6 px from one vertex to the next.
  std::vector<std::vector<DepthMode>> modes;
  for (int i = 0; i < 30; ++i) {
    modes.push_back({Mode(0.1, 5), Mode(0.2 + 0.003 * 2 * i, 6, 0.003)});
  }
  EXPECT_EQ(ChooseModes(Spaced(30), modes), std::vector<int>(30, 1));
}

TEST(DepthModesTest, BestSupportedCourseIsTakenAlongTheWholeFragment) {
  std::vector<std::vector<DepthMode>> modes(20, {Mode(0.2, 4), Mode(0.3, 5)});
  for (int i = 0; i < 4; ++i) modes[i][0].score = 6;  // not enough to pay for a jump
  EXPECT_EQ(ChooseModes(Spaced(20), modes), std::vector<int>(20, 1));
}

TEST(DepthModesTest, VerticesWithoutModesHaveNone) {
  std::vector<std::vector<DepthMode>> modes(20, {Mode(0.2, 8)});
  modes[7].clear();
  const std::vector<int> chosen = ChooseModes(Spaced(20), modes);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(chosen[i], i == 7 ? -1 : 0);
  EXPECT_TRUE(ChooseModes(Spaced(0), {}).empty());
}

}  // namespace
}  // namespace limn
