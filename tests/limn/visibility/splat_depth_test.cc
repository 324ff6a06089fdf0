// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/splat_depth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::LookAt;

TEST(SplatDepth, DiscsHoldTheNearestPoint) {
  const View view = LookAt({0, -6, 0}, {0, 0, 0});
  const DepthImage image = SplatDepth({{0, 0, 0}, {0, 1, 0}, {0, -8, 0}}, view, 1, 8);
  int covered = 0;
  for (const float depth : image.depth) {
    if (depth == 0) continue;
    ++covered;
    EXPECT_EQ(depth, 6);
  }
  EXPECT_NEAR(covered, M_PI * 8 * 8, 10);
}

TEST(SplatDepth, RadiusIsInPixelsOfTheImageAtAnyScale) {
  const View view = LookAt({0, -6, 0}, {0, 0, 0});
  const DepthImage image = SplatDepth({{0, 0, 0}}, view, 4, 5);
  int covered = 0;
  for (const float depth : image.depth) covered += depth > 0;
  EXPECT_NEAR(covered, M_PI * 20 * 20, 30);
}

TEST(SplatDepth, PointsHideWhatIsBehind) {
  const View view = LookAt({0, -6, 0}, {0, 0, 0});
  std::vector<Eigen::Vector3d> wall;
  for (int i = -50; i <= 50; ++i) {
    for (int k = -50; k <= 50; ++k) wall.emplace_back(0.02 * i, 0, 0.02 * k);  // 2 px apart
  }
  const DepthImage image = SplatDepth(wall, view, 1, 2);
  EXPECT_FALSE(IsVisible(view, image, {0.313, 1, -0.171}, 8));
  EXPECT_TRUE(IsVisible(view, image, {0.313, -1, -0.171}, 8));
  EXPECT_TRUE(IsVisible(view, image, {1.6, 1, 0}, 8));  // beside the wall
  for (const Eigen::Vector3d& point : wall) EXPECT_TRUE(IsVisible(view, image, point, 0.1));
}

TEST(SplatDepth, DiscsAcrossTheBorderAreCutOff) {
  const View view = LookAt({0, -6, 0}, {0, 0, 0});
  const double beyond = (319.5 + 1) * 6 / 600;  // 3 px outside the region, which leaves out 2
  const DepthImage image = SplatDepth({{beyond, 0, 0}, {2 * beyond, 0, 0}}, view, 1, 5);
  int covered = 0;
  for (const float depth : image.depth) covered += depth > 0;
  EXPECT_GT(covered, 5);
  EXPECT_LT(covered, M_PI * 25 / 2);
}

}  // namespace
}  // namespace limn
