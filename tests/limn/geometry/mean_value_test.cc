// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/mean_value.h"

#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

// An L, counterclockwise.
const Polyline2d kCorners = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};

double Linear(const Eigen::Vector2d& place) { return 2 - 3 * place.x() + 0.5 * place.y(); }

double ValueAt(const Eigen::Vector2d& place) {
  std::vector<double> values;
  for (const Eigen::Vector2d& corner : kCorners) values.push_back(Linear(corner));
  return MeanValueAt(kCorners, values, place);
}

TEST(MeanValue, LinearValuesAreKept) {
  for (const Eigen::Vector2d& place :
       Polyline2d{{0.5, 0.5}, {3.5, 0.25}, {0.25, 2.5}, {0.999, 1.5}, {2, 0.999}}) {
    EXPECT_NEAR(ValueAt(place), Linear(place), 1e-12) << place.transpose();
  }
}

TEST(MeanValue, OnTheBorder) {
  for (const Eigen::Vector2d& corner : kCorners) EXPECT_EQ(ValueAt(corner), Linear(corner));
  const std::vector<double> values = {0, 8, 0, 0, 0, 0};
  EXPECT_NEAR(MeanValueAt(kCorners, values, {1, 0}), 2, 1e-12);
  EXPECT_NEAR(MeanValueAt(kCorners, values, {1, 1e-9}), 2, 1e-6);
}

}  // namespace
}  // namespace limn
