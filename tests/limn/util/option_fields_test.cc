// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/option_fields.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "limn/util/option_help.h"

namespace limn {
namespace {

enum class Color { kRed, kBlue };

struct ListedOptions {
  double gap_px = 2;
  int max_views = 0;
  bool closed = true;
  Color color = Color::kBlue;
  double set_by_tests = -1;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("gap_px", self.gap_px, Above(0, 1e6), "longest gap, px");
    visit("max_views", self.max_views, ZeroOr(Between(4, 150)), "most views");
    visit("closed", self.closed, OnOrOff(), "whether curves close");
    visit("color", self.color, OneOf({"red", "blue"}), "color of the curves");
  }
};

std::string ListedErrorOf(const ListedOptions& options) {
  try {
    CheckFields(options);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckFields, NamesOptionValueAndRange) {
  for (const ListedOptions& inside :
       {ListedOptions(), ListedOptions{1e6, 4, false, Color::kRed}, ListedOptions{1e-9, 150}}) {
    EXPECT_EQ(ListedErrorOf(inside), "");
  }
  EXPECT_EQ(ListedErrorOf({0}), "gap_px = 0: must be > 0 and <= 1000000");
  EXPECT_EQ(ListedErrorOf({1000001}), "gap_px = 1000001: must be > 0 and <= 1000000");
  EXPECT_NE(ListedErrorOf({NAN}), "");
  EXPECT_EQ(ListedErrorOf({2, 3}), "max_views = 3: must be 0 or >= 4 and <= 150");
  EXPECT_EQ(ListedErrorOf({2, 151}), "max_views = 151: must be 0 or >= 4 and <= 150");
  EXPECT_NE(ListedErrorOf({2, 0, true, static_cast<Color>(2)}), "");
}

TEST(VisitFields, SetsFieldsAndNamesWords) {
  ListedOptions options;
  std::string text;
  ListedOptions::VisitFields(options, [&](const std::string& name, auto& field,
                                          const OptionValues& values, const OptionHelp& help) {
    EXPECT_FALSE(help.text.empty());
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(field)>>) {
      text += name + "=" + WordOf(field, values);
      field = Color::kRed;
    }
  });
  EXPECT_EQ(text, "color=blue");
  EXPECT_EQ(options.color, Color::kRed);
}

}  // namespace
}  // namespace limn
