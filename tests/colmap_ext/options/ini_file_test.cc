// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/ini_file.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;

std::vector<IniEntry> Read(const std::string& text) {
  std::istringstream in(text);
  return ReadIniFile(in, "project.ini");
}

TEST(IniFile, KeysTakeTheNameOfTheirGroup) {
  const auto entries = Read("a=1\r\n\n# comment\n; comment\n[Group]\n  b  =  two words # 2 \nc=\n");
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].key, "a");
  EXPECT_EQ(entries[0].value, "1");
  EXPECT_EQ(entries[1].key, "Group.b");
  EXPECT_EQ(entries[1].value, "two words # 2");
  EXPECT_EQ(entries[1].line, 6);
  EXPECT_EQ(entries[2].key, "Group.c");
  EXPECT_EQ(entries[2].value, "");
}

TEST(IniFile, ValuesMayHoldEqualsSigns) { EXPECT_EQ(Read("a=b=c").at(0).value, "b=c"); }

TEST(IniFile, OtherLinesAreErrors) {
  EXPECT_THAT(ErrorText<IoError>([] { Read("a=1\nnonsense\n"); }),
              HasSubstr("project.ini: line 2: neither"));
  EXPECT_THAT(ErrorText<IoError>([] { ReadIniFile("/nonexistent/project.ini"); }),
              HasSubstr("/nonexistent/project.ini: cannot open: No such file"));
}

}  // namespace
}  // namespace limn
