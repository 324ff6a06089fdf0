// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/errors.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

struct ToyOptions {
  double max_gap_px = 2;
  void Check() const { LIMN_CHECK_OPTION(max_gap_px, > 0); }
};

struct ToyRanges {
  int num_rounds = 4;
  int max_views = 0;
  void Check() const {
    LIMN_CHECK_RANGE(num_rounds, >= 1, <= 1e5);
    LIMN_CHECK_RANGE_OR(max_views, 0, >= 4, <= 150);
  }
};

TEST(CheckOption, NamesOptionValueAndConstraint) {
  EXPECT_NO_THROW(ToyOptions().Check());
  try {
    ToyOptions{-1.5}.Check();
    FAIL() << "a negative gap was accepted";
  } catch (const OptionError& error) {
    EXPECT_STREQ(error.what(), "max_gap_px = -1.5: must be > 0");
  }
  EXPECT_THROW(ToyOptions{NAN}.Check(), OptionError);
}

std::string ErrorOf(const ToyRanges& ranges) {
  try {
    ranges.Check();
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckOption, NamesBothEndsOfARange) {
  for (const ToyRanges& inside : {ToyRanges{1, 0}, ToyRanges{100000, 4}, ToyRanges{4, 150}}) {
    EXPECT_EQ(ErrorOf(inside), "");
  }
  EXPECT_EQ(ErrorOf({0, 0}), "num_rounds = 0: must be >= 1 and <= 1e5");
  EXPECT_EQ(ErrorOf({100001, 0}), "num_rounds = 100001: must be >= 1 and <= 1e5");
  EXPECT_EQ(ErrorOf({1, 3}), "max_views = 3: must be 0 or >= 4 and <= 150");
}

TEST(IoError, NamesPathPlaceAndReason) {
  EXPECT_STREQ(IoError("a/b.txt", "gone").what(), "a/b.txt: gone");
  EXPECT_STREQ(IoError("a/b.txt", "line 3", "odd").what(), "a/b.txt: line 3: odd");
}

}  // namespace
}  // namespace limn
