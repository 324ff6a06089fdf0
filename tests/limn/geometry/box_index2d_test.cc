// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/box_index2d.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Eigen::AlignedBox2d Box(double x0, double y0, double x1, double y1) {
  return {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y1)};
}

TEST(BoxIndex2d, WhatHasAPointInCommon) {
  const BoxIndex2d index(
      {Box(0, 0, 1, 1), Eigen::AlignedBox2d(), Box(3, 0, 4, 9), Box(2, 2, 2, 2)});
  EXPECT_EQ(index.Meeting(Box(-9, -9, 9, 9)), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(index.Meeting(Box(1, 1, 2, 2)), (std::vector<int>{0, 3}));  // touches
  EXPECT_EQ(index.Meeting(Box(3.4, 3, 3.5, 4)), (std::vector<int>{2}));
  EXPECT_TRUE(index.Meeting(Box(1.1, 0, 1.9, 9)).empty());
  EXPECT_TRUE(BoxIndex2d({}).Meeting(Box(0, 0, 1, 1)).empty());
}

}  // namespace
}  // namespace limn
