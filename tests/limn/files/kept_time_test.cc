// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/kept_time.h"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

TEST(KeptTime, IsThatOfTheNewFileToTheNanosecond) {
  const TempDir dir;
  const std::string path = dir.WriteFile("drawing.json", "old");
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(5) +
                                std::chrono::nanoseconds(123456789));
  const fs::file_time_type before = fs::last_write_time(path);
  const KeptTime time(path);
  WriteFileAtomically(path, "new");
  ASSERT_NE(fs::last_write_time(path), before);
  time.Restore();
  EXPECT_EQ(fs::last_write_time(path), before);
}

TEST(KeptTime, NeedsTheFileBeforeAndAfter) {
  const TempDir dir;
  const std::string path = dir.WriteFile("drawing.json", "old");
  const KeptTime time(path);
  fs::remove(path);
  const std::string reason =
      path + ": its time of change cannot be kept: No such file or directory";
  EXPECT_EQ(ErrorText<IoError>([&] { time.Restore(); }), reason);
  EXPECT_EQ(ErrorText<IoError>([&] { const KeptTime missing(path); }), reason);
}

}  // namespace
}  // namespace limn
