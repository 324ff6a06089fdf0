// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/parse_number.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

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
  for (const char* text : {"", "+", "++1", "-+1", "+-1"})
    EXPECT_FALSE(ParseSignedNumber<int>(text)) << text;
}

TEST(ParseNumber, ByStream) {
  const std::pair<const char*, double> kNumbers[] = {
      {"0", 0},
      {"-0", -0.0},
      {"12", 12},
      {"12.", 12},
      {".5", 0.5},
      {"-.5", -0.5},
      {"1e3", 1000},
      {"1E+3", 1000},
      {"1e-3", 0.001},
      {"0.1", 0.1},
      {"007", 7},
      {"0e999", 0},
      {"4.9e-324", 4.9e-324},
      {"1e-310", 1e-310},
      {"0.30000000000000004", 0.30000000000000004},
      {"1.7976931348623157e308", 1.7976931348623157e308},
      {"123456789012345678901234567890", 123456789012345678901234567890.0},
      {"inf", HUGE_VAL},
      {"-INF", -HUGE_VAL},
      {"Infinity", HUGE_VAL}};
  for (const auto& [text, expected] : kNumbers) {
    for (const std::optional<double> number :
         {ParseNumber<double>(text), ParseDoubleByStream(text)}) {
      ASSERT_TRUE(number) << text;
      EXPECT_EQ(*number, expected) << text;
      EXPECT_EQ(std::signbit(*number), std::signbit(expected)) << text;
    }
  }
  EXPECT_TRUE(std::isnan(ParseDoubleByStream("NaN").value()));
  const char* const kOthers[] = {"",    "-",     ".",      "-.",     "e3",      "1e",
                                 "1e+", "1.2.3", "0x1",    "0x1p3",  "1,5",     "1 ",
                                 " 1",  "+1",    "--1",    "1e3.5",  "infi",    "na",
                                 "1f",  "1e999", "-1e999", "1e-400", "-1e-400", "1e-324"};
  for (const char* text : kOthers) {
    EXPECT_FALSE(ParseNumber<double>(text)) << text;
    EXPECT_FALSE(ParseDoubleByStream(text)) << text;
  }
}

}  // namespace
}  // namespace limn
