// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/point_spacing.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(PointSpacing, OfAGridIsItsStep) {
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 60; ++y) points.emplace_back(0.25 * x, 0.25 * y, 100);
  }
  EXPECT_DOUBLE_EQ(PointSpacing(points), 0.25);
  points.insert(points.end(), points.begin(), points.end());  // copies
  points.emplace_back(1e4, 0, 0);                             // a stray one
  EXPECT_DOUBLE_EQ(PointSpacing(points), 0.25);
}

TEST(PointSpacing, WithoutNeighborsThereIsNone) {
  EXPECT_EQ(PointSpacing({}), 0);
  EXPECT_EQ(PointSpacing({{1, 2, 3}, {1, 2, 3}}), 0);
  EXPECT_DOUBLE_EQ(PointSpacing({{1, 2, 3}, {1, 2, 5}}), 2);
}

TEST(PointSpacing, OfManyCopiesTakesNoSquareTime) {
  std::vector<Eigen::Vector3d> points(300'000, Eigen::Vector3d(1, 2, 3));
  points.resize(600'000, Eigen::Vector3d(1, 2, 5));
  EXPECT_DOUBLE_EQ(PointSpacing(points), 2);
}

}  // namespace
}  // namespace limn
