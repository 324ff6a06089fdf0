// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/parse_number.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(ParseNumber, AllOfATextIsANumber) {
  EXPECT_EQ(ParseNumber<int>("-12"), -12);
  EXPECT_EQ(ParseNumber<uint8_t>("255"), 255);
  EXPECT_EQ(ParseNumber<double>("0.125"), 0.125);
  for (const char* text : {"", " 1", "1 ", "+1", "1.5", "0x1", "one"}) {
    EXPECT_FALSE(ParseNumber<int>(text)) << text;
  }
  EXPECT_FALSE(ParseNumber<uint8_t>("256"));
  EXPECT_FALSE(ParseNumber<uint8_t>("-1"));
}

TEST(ParseNumber, OnePlus) {
  EXPECT_EQ(ParseSignedNumber<int>("+1"), 1);
  EXPECT_EQ(ParseSignedNumber<double>("-1"), -1);
  for (const char* text : {"", "+", "++1", "-+1"})
    EXPECT_FALSE(ParseSignedNumber<int>(text)) << text;
}

// Both ways to read floating numbers read the same.
TEST(ParseNumber, ByStream) {
  const char* const kNumbers[] = {"0",
                                  "-0",
                                  "12",
                                  "12.",
                                  ".5",
                                  "-.5",
                                  "1e3",
                                  "1E+3",
                                  "1e-3",
                                  "0.1",
                                  "007",
                                  "inf",
                                  "-INF",
                                  "NaN",
                                  "Infinity",
                                  "4.9e-324",
                                  "0.30000000000000004",
                                  "1.7976931348623157e308",
                                  "123456789012345678901234567890"};
  for (const char* text : kNumbers) {
    const auto expected = ParseNumber<double>(text), number = ParseDoubleByStream(text);
    ASSERT_TRUE(expected) << text;
    ASSERT_TRUE(number) << text;
    EXPECT_TRUE(*number == *expected || (std::isnan(*number) && std::isnan(*expected))) << text;
    EXPECT_EQ(std::signbit(*number), std::signbit(*expected)) << text;
  }
  const char* const kOthers[] = {"",      "-",     ".",     "-.",  "e3", "1e",    "1e+",
                                 "1.2.3", "0x1",   "0x1p3", "1,5", "1 ", " 1",    "+1",
                                 "--1",   "1e3.5", "infi",  "na",  "1f", "1e999", "-1e999"};
  for (const char* text : kOthers) {
    EXPECT_FALSE(ParseNumber<double>(text)) << text;
    EXPECT_FALSE(ParseDoubleByStream(text)) << text;
  }
}

}  // namespace
}  // namespace limn
