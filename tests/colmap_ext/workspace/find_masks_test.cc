// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/find_masks.h"

#include <filesystem>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class FindMasksTest : public ::testing::Test {
 protected:
  void AddImages(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      model_.images.emplace_back();
      model_.images.back().name = name;
      files_.push_back(dir_.WriteFile("images/" + name, "a photograph"));
    }
  }
  void AddMasks(const std::vector<std::string>& names) {
    for (const std::string& name : names) dir_.WriteFile("masks/" + name, "a mask");
  }
  FoundMasks Find(const std::string& path = "masks") const {
    std::vector<int> images(model_.images.size());
    std::iota(images.begin(), images.end(), 0);
    return FindMasks((dir_ / path).string(), model_, images, files_);
  }
  std::string ErrorOf(const std::string& path = "masks") const {
    return ErrorText<IoError>([&] { Find(path); });
  }
  std::string Mask(const std::string& name) const { return (dir_ / ("masks/" + name)).string(); }

  TempDir dir_;
  SparseModel model_;
  std::vector<std::string> files_;
};

TEST_F(FindMasksTest, ThoseOfColmapNeedNoWords) {
  AddImages({"a.jpg", "sub/b.jpg"});
  AddMasks({"a.jpg.png", "sub/b.jpg.png", "a.png", "b.png"});
  const FoundMasks found = Find();
  EXPECT_THAT(found.paths, ElementsAre(Mask("a.jpg.png"), Mask("sub/b.jpg.png")));
  EXPECT_THAT(found.notes, IsEmpty());
  EXPECT_THAT(found.warnings, IsEmpty());
}

TEST_F(FindMasksTest, UsualNamesAreFound) {
  const char* forms[] = {"a.png",      "a.jpg",          "a.TIF",      "a_mask.png", "a.mask.png",
                         "a-mask.png", "a.jpg.mask.png", "mask_a.png", "mask.a.jpg", "a.jpg.tif",
                         "A/../a.png", "a_Mask.PNG",     "a masks.bmp"};
  AddImages({"a.jpg"});
  for (const char* form : forms) {
    fs::remove_all(dir_ / "masks");
    fs::create_directories(dir_ / "masks/A");
    AddMasks({form, "ab.png", "other.png"});
    const FoundMasks found = Find();
    EXPECT_EQ(found.paths[0], fs::path(Mask(form)).lexically_normal()) << form;
    EXPECT_THAT(found.notes, ElementsAre(HasSubstr("1 masks are not named <image name>.png")));
  }
}

TEST_F(FindMasksTest, FoldersOfMasksMayBeFlatOrDeeper) {
  AddImages({"cam1/a.jpg", "cam2/b.jpg", "c.jpg"});
  AddMasks({"a.png", "cam2/b.png", "deeper/c.png", "cam2/a.txt"});
  EXPECT_THAT(Find().paths, ElementsAre(Mask("a.png"), Mask("cam2/b.png"), Mask("deeper/c.png")));
}

TEST_F(FindMasksTest, AmbiguousNamesAreErrors) {
  AddImages({"a.jpg"});
  AddMasks({"a.png", "a_mask.png"});
  EXPECT_EQ(Find().paths[0], Mask("a.png"));  // the nearer name
  AddMasks({"a.tif"});
  EXPECT_THAT(ErrorOf(), AllOf(HasSubstr("may be the mask of \"a.jpg\""), HasSubstr("a.png"),
                               HasSubstr("a.tif"), HasSubstr("call the right one a.jpg.png")));
}

TEST_F(FindMasksTest, MasksOfTwoImagesAreErrors) {
  AddImages({"1/a.jpg", "2/a.jpg"});
  AddMasks({"a.png"});
  EXPECT_THAT(ErrorOf(), AllOf(HasSubstr("a.png: may be the mask of \"1/a.jpg\" or of \"2/a.jpg\""),
                               HasSubstr("call it 2/a.jpg.png")));
}

TEST_F(FindMasksTest, NoneAtAllIsAnError) {
  AddImages({"a.jpg", "b.jpg"});
  AddMasks({"001.png", "002.png"});
  EXPECT_THAT(ErrorOf(),
              AllOf(HasSubstr("has a mask for none of the 2 images"),
                    HasSubstr("that of \"a.jpg\" would be a.jpg.png, there is 001.png")));
  fs::create_directories(dir_ / "empty");
  EXPECT_THAT(ErrorOf("empty"), HasSubstr("there is no picture"));
  EXPECT_THAT(ErrorOf("nowhere"), HasSubstr("nowhere: no such folder (mask_path)"));
}

TEST_F(FindMasksTest, SomeMissingAreCounted) {
  AddImages({"a.jpg", "b.jpg"});
  AddMasks({"a.png"});
  const FoundMasks found = Find();
  EXPECT_THAT(found.paths, ElementsAre(Mask("a.png"), ""));
  EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("1 of 2 images have no mask there")));
}

TEST_F(FindMasksTest, PhotographsAreNoMasks) {
  AddImages({"a.jpg"});
  dir_.WriteFile("images/a_mask.png", "a mask");
  EXPECT_EQ(Find("images").paths[0], (dir_ / "images/a_mask.png").string());
  fs::remove(dir_ / "images/a_mask.png");
  EXPECT_THAT(ErrorOf("images"), HasSubstr("there is no picture"));
}

TEST_F(FindMasksTest, NamesThatLookTheSameAreTheSame) {
  AddImages(
      {"fa\xC3\xA7"
       "ade.jpg"});
  AddMasks(
      {"fac\xCC\xA7"
       "ade.png"});
  EXPECT_EQ(Find().paths[0], Mask("fac\xCC\xA7"
                                  "ade.png"));
}

TEST_F(FindMasksTest, ListsAndSinglePictures) {
  AddImages({"a b.jpg", "c.jpg"});
  AddMasks({"x.png"});
  dir_.WriteFile("sparse/masks.txt",
                 "# a comment\na b.jpg\t../masks/x.png\r\nunused.jpg\tno.png\n");
  const FoundMasks listed = Find("sparse/masks.txt");
  EXPECT_THAT(listed.paths, ElementsAre(Mask("x.png"), ""));
  EXPECT_THAT(listed.warnings, ElementsAre(HasSubstr("1 of 2 images have no mask")));
  dir_.WriteFile("list.txt", "c.jpg\tgone.png\n");
  EXPECT_THAT(ErrorOf("list.txt"), HasSubstr("gone.png: no such mask"));
  dir_.WriteFile("list.txt", "c.jpg gone.png\n");
  EXPECT_THAT(ErrorOf("list.txt"), HasSubstr("line 1"));
  ASSERT_TRUE(cv::imwrite((dir_ / "all.png").string(), cv::Mat(4, 4, CV_8UC1, cv::Scalar(255))));
  const std::string all = (dir_ / "all.png").string();
  EXPECT_THAT(Find("all.png").paths, ElementsAre(all, all));
}

TEST_F(FindMasksTest, FoldersThatAreNotUsedAreSeen) {
  AddImages({"a.jpg"});
  EXPECT_EQ(MasksBeside(dir_ / "images"), "");
  AddMasks({"a.png"});
  EXPECT_EQ(MasksBeside(dir_ / "images"), fs::canonical(dir_ / "masks").string());
  EXPECT_EQ(MaskListOf(dir_ / "masks"), "");
}

}  // namespace
}  // namespace limn::colmap_ext
