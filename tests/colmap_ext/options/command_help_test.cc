// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/command_help.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::HasSubstr;

CommandDescription SomeCommand() {
  return {"curve_drawer",
          "draw curves",
          {{"input_path", "where - or \"so\"", "path", "", {}, true},
           {"quality", ".how well", "word", "low", {"low", "high"}, false},
           {"page", "a 'page' \\ two", "switch", "1", {"0", "1"}, true},
           {"Linking.min_length_px", "shortest, px", "number", "5.5", {}, false},
           {"taus", "several", "numbers", "", {}, false}}};
}

std::string ManPage() {
  std::ostringstream out;
  WriteManPage(SomeCommand(), out);
  return out.str();
}

TEST(ManPage, HasEveryOptionWithItsValueAndDefault) {
  const std::string page = ManPage();
  EXPECT_THAT(page, HasSubstr(".SH NAME\nlimn\\-curve_drawer \\- draw curves\n"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-input_path\\fR \\fIpath\\fR\n"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-quality\\fR \\fBlow\\fR|\\:\\fBhigh\\fR\n"));
  EXPECT_THAT(page, HasSubstr("shortest, px\n(default \\fB5.5\\fR)\n"));
}

TEST(ManPage, HasBasicOptionsFirstAndTheOthersByGroup) {
  const std::string page = ManPage();
  const size_t more = page.find(".SH MORE OPTIONS");
  EXPECT_LT(page.find("input_path"), more);
  EXPECT_LT(page.find("\\-\\-page"), more);
  EXPECT_LT(more, page.find("quality"));
  EXPECT_LT(page.find(".SS Linking\n"), page.find("min_length_px"));
  EXPECT_LT(page.find(".SS Other\n"), page.find("taus"));
}

TEST(ManPage, TakesNoTextForARequest) {
  const std::string page = ManPage();
  EXPECT_THAT(page, HasSubstr("\n\\&.how well\n"));
  EXPECT_THAT(page, HasSubstr("\na \\(aqpage\\(aq \\e two\n"));
}

TEST(ManPage, OfTheProgramHasItsCommands) {
  std::ostringstream out;
  const std::vector<CommandDescription> commands = {SomeCommand(), {"curve_linker", "link", {}}};
  WriteManPage(commands, out);
  EXPECT_THAT(out.str(), HasSubstr(".TP\n\\fBcurve_linker\\fR\nlink\n"));
  EXPECT_THAT(out.str(), HasSubstr(".BR limn\\-curve_drawer (1),\n.BR limn\\-curve_linker (1)\n"));
}

TEST(CompletionWords, AreALinePerOption) {
  std::ostringstream out;
  WriteCompletionWords(SomeCommand(), out);
  EXPECT_EQ(out.str(),
            "-h\n--help_all\n--input_path <path>\n--quality low high\n--page 0 1\n"
            "--Linking.min_length_px <number>\n--taus <numbers>\n");
}

}  // namespace
}  // namespace limn
