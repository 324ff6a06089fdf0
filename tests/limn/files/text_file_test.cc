// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;

TEST(TextFile, TheMarkOfUtf8IsLeftOut) {
  const TempDir dir;
  EXPECT_EQ(ReadTextFile(dir.WriteFile("a.txt", "\xEF\xBB\xBF# a\n")), "# a\n");
  for (const std::string& text : {""s, "a"s, "\xEF\xBB"s, "\xC3\xA9t\xC3\xA9"s, "a\0\0\0"s}) {
    EXPECT_EQ(ReadTextFile(dir.WriteFile("a.txt", text)), text);
  }
}

TEST(TextFile, OtherEncodingsAreNamed) {
  const TempDir dir;
  const auto error_of = [&](const std::string& text) {
    return ErrorText<IoError>([&] { ReadTextFile(dir.WriteFile("a.txt", text)); });
  };
  for (const std::string& text : {"\xFF\xFE#\0"s, "\xFE\xFF\0#"s, "#\0 \0a\0"s, "\0#\0 \0a"s}) {
    EXPECT_THAT(error_of(text), HasSubstr("a.txt: is text in UTF-16")) << text.size();
    EXPECT_THAT(error_of(text), HasSubstr("save it as UTF-8"));
  }
  for (const std::string& text : {"\xFF\xFE\0\0#\0\0\0"s, "\0\0\xFE\xFF\0\0\0#"s}) {
    EXPECT_THAT(error_of(text), HasSubstr("UTF-32"));
  }
}

}  // namespace
}  // namespace limn
