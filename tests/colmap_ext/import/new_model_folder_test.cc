// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/new_model_folder.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/files/temporary_path.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(NewModelFolder, NewAndEmptyFoldersAreFilled) {
  const TempDir dir;
  fs::create_directories(dir / "empty");
  fs::create_directory_symlink(dir / "empty", dir / "link");
  for (const char* name : {"link", "new/sparse/0", "slash/"}) {
    WriteNewModel(MakeModel(), dir / name, ModelFlavor::kBinary);
    ExpectSameModel(ReadModel(dir / name), MakeModel());
  }
  EXPECT_TRUE(fs::exists(dir / "empty" / "images.bin"));
  EXPECT_FALSE(fs::exists(dir / "slash.limn-tmp"));
  EXPECT_FALSE(fs::exists(dir / "slash" / ".limn-tmp"));
}

TEST(NewModelFolder, OthersAreLeftAlone) {
  const TempDir dir;
  const auto error = [&](const char* name) {
    return ErrorText<IoError>([&] { WriteNewModel(MakeModel(), dir / name, ModelFlavor::kText); });
  };
  WriteNewModel(MakeModel(), dir / "model", ModelFlavor::kBinary);
  EXPECT_THAT(error("model"), HasSubstr("model: holds a model already"));
  EXPECT_FALSE(fs::exists(dir / "model" / "images.txt"));
  dir.WriteFile("full/points3D.bin", "");
  EXPECT_THAT(error("full"), HasSubstr("full: the folder is not empty"));
  dir.WriteFile("file", "");
  EXPECT_THAT(error("file"), HasSubstr("file: is not a folder"));
  EXPECT_THAT(error("file/below"), HasSubstr("file"));
  EXPECT_FALSE(fs::exists(dir / "full.limn-tmp"));
}

TEST(NewModelFolder, WhatIsInTheWayOfTheTemporaryFolderIsNotFollowed) {
  const TempDir dir;
  const std::string victim = dir.WriteFile("other/images.bin", "mine");
  fs::create_directory_symlink(dir / "other", dir / "model.limn-tmp");
  WriteNewModel(MakeModel(), dir / "model", ModelFlavor::kBinary);
  EXPECT_EQ(fs::file_size(victim), 4u);
  EXPECT_FALSE(fs::is_symlink(dir / "model"));
}

TEST(NewModelFolder, NothingIsLeftOfAnAbandonedOne) {
  const TempDir dir;
  EXPECT_EXIT(
      {
        std::thread([&] {
          try {
            for (int i = 0;; ++i) {
              WriteNewModel(MakeModel(), dir / std::to_string(i), ModelFlavor::kText);
            }
          } catch (const IoError&) {
            _exit(2);  // it would say a second line
          }
        }).detach();
        while (!fs::exists(dir / "5")) std::this_thread::yield();
        AbandonWrites();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const fs::directory_iterator folders(dir.path());
        _exit(std::any_of(begin(folders), end(folders), [](const auto& entry) {
          return entry.path().extension() == ".limn-tmp";
        }));
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace limn::colmap_ext
