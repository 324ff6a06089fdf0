// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/file_set.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {
namespace {

TEST(FileSet, FilesAreThemselvesByAnyName) {
  const TempDir dir;
  const std::string a = dir.WriteFile("a", "same");
  const std::string b = dir.WriteFile("b", "same");
  const std::string nowhere = (dir / "nowhere").string();
  std::filesystem::create_symlink("a", dir / "link");
  std::filesystem::create_hard_link(dir / "a", dir / "second");
  const FileSet set({a, nowhere});
  EXPECT_TRUE(set.Contains(a));
  EXPECT_TRUE(set.Contains((dir / "." / "a").string()));
  EXPECT_TRUE(set.Contains((dir / "link").string()));
  EXPECT_TRUE(set.Contains((dir / "second").string()));
  EXPECT_FALSE(set.Contains(b));
  EXPECT_FALSE(set.Contains(nowhere));
}

}  // namespace
}  // namespace limn::colmap_ext
