#include "limn/util/printable.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Printable, HasNoControlCharacters) {
  EXPECT_EQ(Printable("a\nb\r\t\x1B[2J\x7F"), "a?b???[2J?");
  EXPECT_EQ(Printable("C1: \xC2\x9B"
                      "31m"),
            "C1: ?31m");
}

TEST(Printable, KeepsOtherText) {
  const std::string text =
      "\xC3\x9C"
      "ber \xC2\xA9 \xE6\x97\xA5 ~";
  EXPECT_EQ(Printable(text), text);
  EXPECT_EQ(Printable("cut \xC2"), "cut \xC2");
}

TEST(WithCommas, GroupsThousands) {
  EXPECT_EQ(WithCommas(0), "0");
  EXPECT_EQ(WithCommas(-999), "-999");
  EXPECT_EQ(WithCommas(1000), "1,000");
  EXPECT_EQ(WithCommas(-123456), "-123,456");
  EXPECT_EQ(WithCommas(1234567), "1,234,567");
}

}  // namespace
}  // namespace limn
