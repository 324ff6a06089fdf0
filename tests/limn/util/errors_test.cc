#include "limn/util/errors.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

struct ToyOptions {
  double max_gap_px = 2;
  void Check() const { LIMN_CHECK_OPTION(max_gap_px, > 0); }
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

TEST(IoError, NamesPathPlaceAndReason) {
  EXPECT_STREQ(IoError("a/b.txt", "gone").what(), "a/b.txt: gone");
  EXPECT_STREQ(IoError("a/b.txt", "line 3", "odd").what(), "a/b.txt: line 3: odd");
}

}  // namespace
}  // namespace limn
