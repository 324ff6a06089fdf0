// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/nearest_word.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const std::vector<std::string> kWords = {"workspace_path", "output_path", "image_path", "box",
                                         "Sketch.gap_px",  "Drawing.gap", "Linking.gap"};

TEST(NearestWord, TyposAreMended) {
  EXPECT_EQ(NearestWord("worksapce_path", kWords), "workspace_path");  // exchanged
  EXPECT_EQ(NearestWord("workspacepath", kWords), "workspace_path");   // missing
  EXPECT_EQ(NearestWord("images_path", kWords), "image_path");         // too many
  EXPECT_EQ(NearestWord("bux", kWords), "box");                        // another
  EXPECT_EQ(NearestWord("box", kWords), "box");
}

TEST(NearestWord, WhatIsTooDifferentIsNotMeant) {
  EXPECT_EQ(NearestWord("nonsense", kWords), "");
  EXPECT_EQ(NearestWord("", kWords), "");
  EXPECT_EQ(NearestWord("box", {}), "");
  EXPECT_EQ(NearestWord(std::string(100'000, 'x'), kWords), "");
}

TEST(NearestWord, TheGroupMayBeLeftOut) {
  EXPECT_EQ(NearestWord("gap_px", kWords), "Sketch.gap_px");
  EXPECT_EQ(NearestWord("gap", kWords), "");  // of which group?
}

TEST(DidYouMean, IsEmptyIfNothingIsNear) {
  EXPECT_EQ(DidYouMean("bux", kWords), ": did you mean box?");
  EXPECT_EQ(DidYouMean("nonsense", kWords), "");
}

}  // namespace
}  // namespace limn
