// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/file_status.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "colmap_ext/temp_dir.h"
#include "limn/files/writable_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

TEST(FileStatus, ALinkIsOneInItsFolderAndAFileByItsPath) {
  const TempDir dir;
  const std::string file = dir.WriteFile("file", "text");
  fs::create_directory(dir / "folder");
  fs::create_symlink("file", dir / "link");
  fs::create_symlink("nowhere", dir / "dangling");
  ASSERT_EQ(mkfifo((dir / "pipe").c_str(), 0666), 0);
  const auto folder = WritableFolder::Find(OutputPath(dir.path(), ""));
  ASSERT_TRUE(folder);
  EXPECT_EQ(folder->StatusOf("file")->kind, FileKind::kFile);
  EXPECT_EQ(folder->StatusOf("folder")->kind, FileKind::kFolder);
  EXPECT_EQ(folder->StatusOf("link")->kind, FileKind::kLink);
  EXPECT_EQ(folder->StatusOf("dangling")->kind, FileKind::kLink);
  EXPECT_EQ(folder->StatusOf("pipe")->kind, FileKind::kOther);
  EXPECT_FALSE(folder->StatusOf("nowhere"));
  const auto by_link = StatusOfFile((dir / "link").string());
  ASSERT_TRUE(by_link);
  EXPECT_EQ(by_link->kind, FileKind::kFile);
  EXPECT_EQ(by_link->id, folder->StatusOf("file")->id);
  EXPECT_NE(folder->StatusOf("link")->id, by_link->id);
  EXPECT_FALSE(StatusOfFile((dir / "dangling").string()));
}

}  // namespace
}  // namespace limn
