// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/quantiles.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Quantiles, CountEveryValueOnce) {
  const std::vector<double> values = {5, 1, 4, 2, 3, 10, 9, 8, 7, 6};
  EXPECT_DOUBLE_EQ(*Quantile(values, 0.5), 5);
  EXPECT_DOUBLE_EQ(*Quantile(values, 0.9), 9);
  EXPECT_DOUBLE_EQ(*Quantile(values, 0), 1);
  EXPECT_DOUBLE_EQ(*Quantile(values, 1), 10);
  EXPECT_FALSE(Quantile({}, 0.5));
}

TEST(Quantiles, WeightsCount) {
  EXPECT_DOUBLE_EQ(*WeightedQuantile({{1, 1}, {2, 8}, {3, 1}}, 0.5), 2);
  EXPECT_DOUBLE_EQ(*WeightedQuantile({{1, 1}, {2, 1}, {3, 8}}, 0.5), 3);
  EXPECT_FALSE(WeightedQuantile({{1, 0}}, 0.5));
}

}  // namespace
}  // namespace limn
