// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/curvelets.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector2d;

Edgel MakeEdgel(double x, double y, double tangent_rad) {
  Edgel edgel;
  edgel.position_px = Vector2d(x, y);
  edgel.tangent_rad = tangent_rad;
  edgel.position_sigma_px = 0.05f;
  return edgel;
}

TEST(CurveletBuilder, ArcInOrderOfTangents) {
  // Every pixel of arc along a circle of radius 10.
  std::vector<Edgel> edgels;
  for (int i = 0; i < 12; ++i) {
    const double a = 0.1 * i;
    edgels.push_back(MakeEdgel(10 * std::cos(a), 10 * std::sin(a), a + 0.5 * std::numbers::pi));
  }
  const LinkingOptions options;
  CurveletBuilder builder(edgels, options);
  const auto curvelets = builder.Around(6);
  ASSERT_EQ(curvelets.size(), 1u);
  EXPECT_EQ(curvelets[0], (Curvelet{3, 4, 5, 6, 7, 8, 9}));
}

TEST(CurveletBuilder, TooSharpACurveIsNone) {
  // Radius 2.5 px: curvature 0.4.
  std::vector<Edgel> edgels;
  for (int i = 0; i < 8; ++i) {
    const double a = 0.4 * i;
    edgels.push_back(MakeEdgel(2.5 * std::cos(a), 2.5 * std::sin(a), a + 0.5 * std::numbers::pi));
  }
  LinkingOptions options;
  options.position_tolerance_px = 0.1;
  options.max_position_tolerance_px = 0.1;
  options.angle_tolerance_deg = 2;
  EXPECT_TRUE(CurveletBuilder(edgels, options).Around(4).empty());
  options.max_curvature = 0.5;
  EXPECT_FALSE(CurveletBuilder(edgels, options).Around(4).empty());
}

TEST(CurveletBuilder, TooShortACurveletIsNone) {
  std::vector<Edgel> edgels;
  for (int x = 0; x < 3; ++x) edgels.push_back(MakeEdgel(x, 0, 0));
  LinkingOptions options;
  options.min_curvelet_px = 2.5;
  EXPECT_TRUE(CurveletBuilder(edgels, options).Around(1).empty());
  options.min_curvelet_px = 1.5;
  EXPECT_FALSE(CurveletBuilder(edgels, options).Around(1).empty());
}

TEST(CurveletBuilder, EdgelsBesideEachOtherAreOfTwoCurvelets) {
  // Half a pixel apart: each is within the tolerance of a curve through the other.
  std::vector<Edgel> edgels;
  for (int x = 0; x < 7; ++x) edgels.push_back(MakeEdgel(x, 0, 0));
  edgels.push_back(MakeEdgel(5, 0.5, 0));
  const LinkingOptions options;
  CurveletBuilder builder(edgels, options);
  const auto holds = [](const Curvelet& curvelet, EdgelId id) {
    return std::find(curvelet.begin(), curvelet.end(), id) != curvelet.end();
  };
  int num_with_either = 0;
  for (const Curvelet& curvelet : builder.Around(3)) {
    EXPECT_FALSE(holds(curvelet, 5) && holds(curvelet, 7));
    num_with_either += holds(curvelet, 5) || holds(curvelet, 7);
  }
  EXPECT_EQ(num_with_either, 2);
}

TEST(CurveletBuilder, BranchesMakeTwoCurvelets) {
  // A trunk along x that forks into two arms turning by 40 degrees up and down.
  std::vector<Edgel> edgels;
  for (int x = -3; x <= 0; ++x) edgels.push_back(MakeEdgel(x, 0, 0));
  for (const int side : {-1, 1}) {
    const double turn = side * 0.35;
    for (int k = 1; k <= 3; ++k) {
      edgels.push_back(MakeEdgel(k * std::cos(turn), k * std::sin(turn), turn));
    }
  }
  const LinkingOptions options;
  CurveletBuilder builder(edgels, options);
  const auto curvelets = builder.Around(3);
  EXPECT_EQ(curvelets.size(), 2u);
  for (const Curvelet& curvelet : curvelets) {
    EXPECT_TRUE(std::find(curvelet.begin(), curvelet.end(), 3) != curvelet.end());
  }
}

TEST(CurveletBuilder, OpposedTangentsDoNotGroup) {
  std::vector<Edgel> edgels;
  for (int x = 0; x < 7; ++x) edgels.push_back(MakeEdgel(x, 0, x == 3 ? std::numbers::pi : 0));
  const LinkingOptions options;
  CurveletBuilder builder(edgels, options);
  EXPECT_TRUE(builder.Around(3).empty());
  for (const Curvelet& curvelet : builder.Around(2)) {
    EXPECT_TRUE(std::find(curvelet.begin(), curvelet.end(), 3) == curvelet.end());
  }
}

}  // namespace
}  // namespace limn
