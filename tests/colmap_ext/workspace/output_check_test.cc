#include "colmap_ext/workspace/output_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using testing::HasSubstr;

TEST(CheckWritable, AcceptsFoldersAndWhatCanBecomeOne) {
  const TempDir dir;
  CheckWritable(dir.path());
  CheckWritable(dir / "new/folder");
  CheckWritable("relative/folder");
  EXPECT_FALSE(std::filesystem::exists(dir / "new"));
}

TEST(CheckWritable, RefusesFilesAndDeadLinksInTheWay) {
  const TempDir dir;
  const std::string file = dir.WriteFile("file", "");
  std::filesystem::create_symlink("/nowhere/at/all", dir / "link");
  for (const std::string& path : {file, file + "/folder", (dir / "link").string()}) {
    EXPECT_THAT(ErrorText<IoError>([&] { CheckWritable(path); }), HasSubstr("is no folder"));
  }
}

TEST(CheckWritable, RefusesReadOnlyFolders) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TempDir dir;
  std::filesystem::permissions(
      dir.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(ErrorText<IoError>([&] { CheckWritable(dir / "new"); }),
              HasSubstr("Permission denied"));
  std::filesystem::permissions(dir.path(), std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace limn::colmap_ext
