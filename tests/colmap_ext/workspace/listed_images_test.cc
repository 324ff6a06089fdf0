// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/listed_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ListedImagesTest : public ::testing::Test {
 protected:
  ListedImagesTest() {
    for (const char* name : {"a.jpg", "sub/b.jpg", "1/c.jpg", "2/c.jpg"}) {
      model_.images.emplace_back();
      model_.images.back().name = name;
    }
  }

  ListedImages Read(const std::string& content) const {
    return ReadListedImages(dir_.WriteFile("list.txt", content), model_);
  }

  TempDir dir_;
  SparseModel model_;
};

TEST_F(ListedImagesTest, ListsOfOtherProgramsAreRead) {
  for (const char* list :
       {"a.jpg\nsub/b.jpg\n",
        "\xEF\xBB\xBF"
        "a.jpg\r\nsub/b.jpg\r\n\r\n",
        "images/a.jpg\nimages/sub/b.jpg", "C:\\me\\images\\a.jpg\r\nC:\\me\\images\\sub\\b.jpg",
        "  ./a.jpg \n/abs/images/sub/b.jpg", "a.jpg\nb.jpg\n", "sub\\b.jpg\na.jpg\na.jpg"}) {
    const ListedImages listed = Read(list);
    EXPECT_THAT(listed.names, ElementsAre("a.jpg", "sub/b.jpg")) << list;
    EXPECT_THAT(listed.unknown, IsEmpty()) << list;
  }
}

TEST_F(ListedImagesTest, WhatNamesNoImageOrTwoIsTold) {
  EXPECT_EQ(Read("a.jpg\nd.jpg\ne.jpg\n").unknown, "d.jpg");
  EXPECT_EQ(Read("c.jpg\n").unknown, "c.jpg");
  EXPECT_THAT(Read("2/c.jpg\n").names, ElementsAre("2/c.jpg"));
  EXPECT_EQ(Read("A.jpg\n").unknown, "A.jpg");
  EXPECT_EQ(Read("xa.jpg\n").unknown, "xa.jpg");
  EXPECT_THAT(Read("\n").names, IsEmpty());
}

TEST_F(ListedImagesTest, HostileListsTakeNoTime) {
  EXPECT_EQ(Read(std::string(1'000'000, '/') + "x\n").unknown.size(), 1'000'001u);
  std::string list = "a.jpg\n";
  for (int i = 0; i < 100'000; ++i) list += "\xE9" + std::to_string(i) + "\n";
  EXPECT_EQ(Read(list).unknown, "\\xE90");
}

TEST_F(ListedImagesTest, OtherEncodings) {
  model_.images[0].name = "\xE6\x88\xAA\xE5\x9B\xBE.jpg";
  EXPECT_THAT(Read("D:\\x\\\xBD\xD8\xCD\xBC.jpg\n").names, ElementsAre(model_.images[0].name));
  // The model in a code page, the list in UTF-8.
  model_.images[0].name_bytes = "\xBD\xD8\xCD\xBC.jpg";
  model_.images[0].name = "\\xBD\\xD8\\xCD\\xBC.jpg";
  EXPECT_THAT(Read("\xBD\xD8\xCD\xBC.jpg\n").names, ElementsAre(model_.images[0].name));
  EXPECT_THAT(Read("images/\xBD\xD8\xCD\xBC.jpg\n").names, ElementsAre(model_.images[0].name));
  EXPECT_THAT(Read("images/\xE6\x88\xAA\xE5\x9B\xBE.jpg\n").names,
              ElementsAre(model_.images[0].name));
  EXPECT_THAT(ErrorText<IoError>([&] {
                Read(
                    std::string("\xFF\xFE"
                                "a\0.\0",
                                6));
              }),
              HasSubstr("UTF-16"));
}

}  // namespace
}  // namespace limn::colmap_ext
