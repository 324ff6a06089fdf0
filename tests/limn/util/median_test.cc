// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/median.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Median, IsTheMiddleOfTheSortedValues) {
  EXPECT_EQ(Median({3}), 3);
  EXPECT_EQ(Median({9, 1, 5}), 5);
  EXPECT_EQ(Median({7, 7, 1, 0, 100}), 7);
}

TEST(Median, OfAnEvenNumberIsTheUpperOfTwo) {
  EXPECT_EQ(Median({4, 2}), 4);
  EXPECT_EQ(Median({8, 2, 6, 4}), 6);
}

TEST(Median, OfNothingIsZero) { EXPECT_EQ(Median({}), 0); }

}  // namespace
}  // namespace limn
