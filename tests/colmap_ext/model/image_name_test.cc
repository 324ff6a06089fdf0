// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/image_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

TEST(ProblemOfName, AcceptsWhatMayBeJoinedToAFolder) {
  for (const char* name : {"a.jpg", "sub folder/b c.png", "..a/b", "Fläche.jpg", "日本.png",
                           "\xF0\x9F\x98\x80.png", "C:\\a.jpg"}) {
    EXPECT_EQ(ProblemOfName(name), "") << name;
  }
}

TEST(ProblemOfName, RefusesTheRest) {
  EXPECT_THAT(ProblemOfName(""), HasSubstr("no name"));
  EXPECT_THAT(ProblemOfName(std::string(4097, 'a')), HasSubstr("longer than 4096 bytes"));
  EXPECT_THAT(ProblemOfName(std::string("a\0b", 3)), HasSubstr("NUL"));
  for (const char* name : {"/a.jpg", "../a.jpg", "a/../../b.jpg"}) {
    EXPECT_THAT(ProblemOfName(name), HasSubstr("leads out of the image folder"));
  }
}

TEST(Utf8Name, IsTheNameOrItsBytes) {
  for (const char* name : {"a b.jpg",
                           "Fl\xC3\xA4"
                           "che",
                           "\xF0\x9F\x98\x80.png"}) {
    EXPECT_EQ(Utf8Name(name), name);
  }
  EXPECT_EQ(Utf8Name("Fl\xE4"
                     "che/a.jpg"),
            "Fl\\xE4che/a.jpg");
  // Cut, overlong, surrogate, above U+10FFFF, lone continuation.
  for (const char* name : {"a\xE6\x97", "\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\xAF",
                           "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80"}) {
    EXPECT_THAT(Utf8Name(name), HasSubstr("\\x")) << name;
  }
}

TEST(ProblemOfNameInText, RefusesWhatEndsALine) {
  for (const char* name : {"a b.jpg", "f/\xC3\xA4 \"q\".jpg", "a\x1B.jpg"}) {
    EXPECT_EQ(ProblemOfNameInText(name), "") << name;
  }
  for (const char* name : {"a\n1 2.jpg", " a.jpg", "a.jpg ", "a.jpg\r"}) {
    EXPECT_THAT(ProblemOfNameInText(name), HasSubstr(name));
  }
}

TEST(HintForMissing, NamesAFileThatDiffersByAccident) {
  const TempDir dir;
  dir.WriteFile("sub/View 1.JPG", "");
  for (const char* name : {"sub/view 1.jpg", "sub/View 1.png", "sub\\View 1.JPG"}) {
    EXPECT_THAT(HintForMissing(dir.path(), name), HasSubstr("; ")) << name;
    EXPECT_THAT(HintForMissing(dir.path(), name), HasSubstr("View 1.JPG is there")) << name;
  }
  EXPECT_EQ(HintForMissing(dir.path(), "sub/other.jpg"), "");
  EXPECT_EQ(HintForMissing(dir.path(), "elsewhere/View 1.JPG"), "");
}

}  // namespace
}  // namespace limn::colmap_ext
