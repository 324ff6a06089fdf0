// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/match_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/workspace/name_encoding.h"

namespace limn::colmap_ext {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kComposed =
    "fa\xC3\xA7"
    "ade.jpg";
const std::string kDecomposed =
    "fac\xCC\xA7"
    "ade.jpg";
// "screenshot", in Chinese.
const std::string kGbk = "\xBD\xD8\xCD\xBC";
const std::string kChinese = "\xE6\x88\xAA\xE5\x9B\xBE";
// The same in UTF-8, taken for code page 437 and converted to UTF-8.
const std::string kGarbled = "\xC2\xB5\xC3\xAA\xC2\xAC\xCF\x83\xC2\xA2\xE2\x95\x9B";

TEST(NameEncoding, AllCodePagesAreKnown) {
  for (const NameEncoding& encoding : NameEncodings()) {
    EXPECT_EQ(TextOfName("a b\\c.jpg", encoding), "a b/c.jpg") << encoding.text;
  }
  EXPECT_EQ(TextOfName(kDecomposed, NameEncodings()[0]), kComposed);
  EXPECT_FALSE(TextOfName(kGbk, NameEncodings()[0]));
}

TEST(MatchNames, ComposedAndDecomposedAreTheSame) {
  EXPECT_THAT(MatchNames({kComposed}, {"x.jpg", kDecomposed}).file_of, ElementsAre(1));
  EXPECT_THAT(MatchNames({kDecomposed}, {"x.jpg", kComposed}).file_of, ElementsAre(1));
  // In folders, too.
  const NameMatches matches =
      MatchNames({kComposed + "/a.jpg", "b\\c.jpg"}, {"b/c.jpg", kDecomposed + "/a.jpg"});
  EXPECT_THAT(matches.file_of, ElementsAre(1, 0));
  EXPECT_THAT(matches.ways, ElementsAre(HasSubstr("2 names")));
}

TEST(MatchNames, CodePagesOnEitherSide) {
  const std::vector<std::string> in_gbk = {kGbk + "1.jpg", kGbk + "2.jpg"};
  const std::vector<std::string> in_utf8 = {kChinese + "2.jpg", kChinese + "1.jpg"};
  EXPECT_THAT(MatchNames(in_gbk, in_utf8).file_of, ElementsAre(1, 0));
  EXPECT_THAT(MatchNames(in_utf8, in_gbk).file_of, ElementsAre(1, 0));
  EXPECT_THAT(MatchNames(in_gbk, in_utf8).ways,
              ElementsAre(HasSubstr("2 names are in gb18030, those of the files in UTF-8 (")));
}

TEST(MatchNames, GarbledByAnArchive) {
  EXPECT_THAT(MatchNames({kChinese + ".jpg"}, {kGarbled + ".jpg"}).file_of, ElementsAre(0));
  EXPECT_THAT(MatchNames({kGarbled + ".jpg"}, {kChinese + ".jpg"}).file_of, ElementsAre(0));
}

TEST(MatchNames, MoreNamesDecideTheEncoding) {
  // E9 is e acute in windows-1252 and a Cyrillic letter in windows-1251; C0 differs likewise.
  const std::string latin1 = "\xC3\xA9.jpg", latin2 = "\xC3\x80.jpg", cyrillic = "\xD0\xB9.jpg";
  const NameMatches matches = MatchNames({"\xE9.jpg", "\xC0.jpg"}, {cyrillic, latin1, latin2});
  EXPECT_THAT(matches.file_of, ElementsAre(1, 2));
  EXPECT_THAT(matches.ambiguous, IsEmpty());
  const NameMatches one = MatchNames({"\xE9.jpg"}, {cyrillic, latin1});
  EXPECT_THAT(one.file_of, ElementsAre(-1));
  ASSERT_THAT(one.ambiguous, SizeIs(1));
}

TEST(MatchNames, OthersHaveNoFile) {
  EXPECT_THAT(MatchNames({"a.jpg", "B.jpg"}, {"b.jpg", "a.png"}).file_of, Each(-1));
  EXPECT_THAT(MatchNames({"a.jpg"}, {}).file_of, Each(-1));
  EXPECT_THAT(MatchNames({}, {"a.jpg"}).file_of, IsEmpty());
  // Two files, or two names, of one text.
  const std::string composed = "\xC3\xA9\xC3\xA9.jpg", decomposed =
                                                           "e\xCC\x81"
                                                           "e\xCC\x81.jpg";
  EXPECT_THAT(MatchNames({"\xC3\xA9"
                          "e\xCC\x81.jpg"},
                         {composed, decomposed})
                  .file_of,
              Each(-1));
  EXPECT_THAT(MatchNames({kComposed, kDecomposed}, {"./x.jpg"}).file_of, Each(-1));
}

}  // namespace
}  // namespace limn::colmap_ext
