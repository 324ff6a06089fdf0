// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/temporary_path.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

void Fill(const fs::path& folder, const std::string& text) {
  fs::create_directories(folder / "sub");
  std::ofstream(folder / "sub" / "file") << text;
}

size_t NumEntries(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(TemporaryPath, ReplacesAFolderAsAWhole) {
  const TemporaryFolder folder;
  const std::string result = folder.Path("result");
  Fill(result, "old");
  fs::create_symlink("/", fs::path(result) / "root");
  {
    TemporaryPath temporary(OutputPath(result) + kTemporarySuffix, &MakeEmptyFolder);
    Fill(temporary.path().string(), "new");
    EXPECT_EQ(folder.Read(result + "/sub/file"), "old");
    EXPECT_EQ(temporary.Replace("result"), std::error_code());
    EXPECT_EQ(folder.Read(result + "/sub/file"), "new");
  }
  EXPECT_EQ(folder.Read(result + "/sub/file"), "new");
  EXPECT_FALSE(fs::exists(fs::path(result) / "root"));
  EXPECT_EQ(NumEntries(folder.Path("")), 1u);
}

TEST(TemporaryPath, ReplacesNothingThatIsNotThere) {
  const TemporaryFolder folder;
  {
    TemporaryPath temporary(OutputPath(folder.Path("result.limn-tmp")), &MakeEmptyFolder);
    Fill(temporary.path().string(), "new");
    EXPECT_EQ(temporary.Replace("result"), std::errc::no_such_file_or_directory);
  }
  EXPECT_EQ(NumEntries(folder.Path("")), 0u);
}

TEST(TemporaryPath, WhatAKilledRunHasLeftIsRemoved) {
  const TemporaryFolder folder;
  Fill(folder.Path("result.limn-tmp"), "old");
  const TemporaryPath temporary(OutputPath(folder.Path("result.limn-tmp")), &MakeEmptyFolder);
  EXPECT_EQ(NumEntries(folder.Path("result.limn-tmp")), 0u);
}

}  // namespace
}  // namespace limn
