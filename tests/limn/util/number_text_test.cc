// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/number_text.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(NumberText, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(NumberText(0.1), "0.1");
  EXPECT_EQ(NumberText(-3), "-3");
  EXPECT_EQ(NumberText(0.1 + 0.2), "0.30000000000000004");
}

TEST(ShortNumber, HasThreeDigits) {
  EXPECT_EQ(ShortNumber(0.125), "0.125");
  EXPECT_EQ(ShortNumber(52.123), "52.1");
  EXPECT_EQ(ShortNumber(1.2e6), "1.2e+06");
  EXPECT_EQ(ShortNumber(-0.0000124), "-1.24e-05");
}

TEST(RoundedText, HasNoZerosAtItsEnd) {
  EXPECT_EQ(RoundedText(0.5, 2), "0.5");
  EXPECT_EQ(RoundedText(-0.256, 2), "-0.26");
  EXPECT_EQ(RoundedText(100, 0), "100");
  EXPECT_EQ(RoundedText(100, 2), "100");
  EXPECT_EQ(RoundedText(-0.001, 2), "0");
}

}  // namespace
}  // namespace limn
