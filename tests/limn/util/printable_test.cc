// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/printable.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(Printable("a\nb\r\t\x1B[2J\x7F"), "a\\x0ab\\x0d\\x09\\x1b[2J\\x7f");
  EXPECT_EQ(Printable("C1: \u009B31m"), "C1: \\u009b31m");
  EXPECT_EQ(Printable("\u202Egpj.exe, two\u2028lines, \u200B\uFEFF\U000E0041"),
            "\\u202egpj.exe, two\\u2028lines, \\u200b\\ufeff\\ue0041");
  EXPECT_EQ(Printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(Printable("cut \xC2"), "cut \\xc2");
  EXPECT_EQ(Printable("Fl\xE4"
                      "che \x9B"),
            "Fl\\xe4che \\x9b");
  // Longer than needed, half of a surrogate, beyond Unicode.
  EXPECT_EQ(Printable("\xC0\x8A \xED\xA0\x80 \xF4\x90\x80\x80"),
            "\\xc0\\x8a \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80");
}

TEST(Printable, KeepsOtherText) {
  const std::string text =
      "\xC3\x9C"
      "ber \xC2\xA9 \xE6\x97\xA5 ~ \U0001F600 \u00A0";
  EXPECT_EQ(Printable(text), text);
}

TEST(PrintableLine, LeavesOutTheMiddleOfALongText) {
  EXPECT_EQ(PrintableLine("a\n"), "a\\x0a");
  EXPECT_EQ(PrintableLine(std::string(10'000, 'x')).size(), 10'000u);
  const std::string cut = PrintableLine("first" + std::string(10'000'000, 'x') + "last");
  EXPECT_TRUE(cut.starts_with("firstx"));
  EXPECT_TRUE(cut.ends_with("xlast"));
  EXPECT_NE(cut.find("x [9,990,009 bytes] x"), std::string::npos);
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
