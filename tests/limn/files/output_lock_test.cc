// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/output_lock.h"

#include <optional>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

// What another lock on the folder says; empty if it is granted. flock is per open file, so one
// process can stand for two.
std::string Refusal(const fs::path& folder, LockMode mode) {
  return ErrorText<IoError>([&] { const OutputLock lock(folder, mode); });
}

TEST(OutputLock, KeepsOthersOutAndNamesTheProcess) {
  const TempDir dir;
  const OutputLock lock(dir.path(), LockMode::kExclusive);
  EXPECT_THAT(Refusal(dir.path(), LockMode::kExclusive),
              AllOf(HasSubstr((dir / ".lock").string()),
                    HasSubstr("in use by process " + std::to_string(getpid()))));
  EXPECT_NE(Refusal(dir.path(), LockMode::kShared), "");
}

TEST(OutputLock, ThoseThatShareItRunTogetherButNotWithOthers) {
  const TempDir dir;
  std::optional<OutputLock> first, second;
  first.emplace(dir.path(), LockMode::kShared);
  second.emplace(dir.path(), LockMode::kShared);
  EXPECT_NE(Refusal(dir.path(), LockMode::kExclusive), "");
  first.reset();
  EXPECT_TRUE(fs::exists(dir / ".lock"));
  EXPECT_NE(Refusal(dir.path(), LockMode::kExclusive), "");
  second.reset();
  EXPECT_FALSE(fs::exists(dir / ".lock"));
  EXPECT_EQ(Refusal(dir.path(), LockMode::kExclusive), "");
}

TEST(OutputLock, SharersComeAndGoWithoutHarm) {
  const TempDir dir;
  std::vector<std::thread> sharers;
  for (int t = 0; t < 3; ++t) {
    sharers.emplace_back([&] {
      for (int i = 0; i < 1000; ++i) ASSERT_EQ(Refusal(dir / "curves", LockMode::kShared), "");
    });
  }
  for (std::thread& sharer : sharers) sharer.join();
  EXPECT_FALSE(fs::exists(dir / "curves/.lock"));
}

TEST(OutputLock, LeavesNothingBehind) {
  const TempDir dir;
  { const OutputLock lock(dir / "new/curves", LockMode::kExclusive); }
  EXPECT_FALSE(fs::exists(dir / "new"));
  {
    const OutputLock lock(dir / "new/curves", LockMode::kExclusive);
    dir.WriteFile("new/drawing.ply", "ply");
  }
  EXPECT_TRUE(fs::exists(dir / "new/drawing.ply"));
  EXPECT_FALSE(fs::exists(dir / "new/curves"));
}

TEST(OutputLock, VanishesWithItsProcess) {
  const TempDir dir;
  const pid_t child = fork();
  if (child == 0) {
    const OutputLock lock(dir.path(), LockMode::kExclusive);
    _exit(0);  // as if it were killed: no destructor runs
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(fs::exists(dir / ".lock"));
  EXPECT_EQ(Refusal(dir.path(), LockMode::kExclusive), "");
}

TEST(OutputLock, FollowsNoLink) {
  const TempDir dir;
  const std::string victim = dir.WriteFile("victim", "a text");
  for (const fs::path& target : {fs::path(victim), dir / "dangling"}) {
    fs::create_directories(dir / "curves");
    fs::create_symlink(target, dir / "curves/.lock");
    EXPECT_THAT(Refusal(dir / "curves", LockMode::kExclusive),
                AllOf(HasSubstr((dir / "curves/.lock").string()), HasSubstr("is a link to")));
    fs::remove(dir / "curves/.lock");
  }
  EXPECT_EQ(fs::file_size(victim), 6u);
  EXPECT_FALSE(fs::exists(dir / "dangling"));
}

TEST(OutputLock, LeavesFilesOfOthersAlone) {
  const TempDir dir;
  const std::string victim = dir.WriteFile("victim", "");
  fs::create_directories(dir / "curves");
  fs::create_hard_link(victim, dir / "curves/.lock");
  EXPECT_THAT(Refusal(dir / "curves", LockMode::kExclusive),
              HasSubstr("is not a lock file of limn"));
  fs::remove(dir / "curves/.lock");
  dir.WriteFile("curves/.lock", "a text");
  EXPECT_NE(Refusal(dir / "curves", LockMode::kExclusive), "");
  EXPECT_EQ(fs::file_size(dir / "curves/.lock"), 6u);
  fs::remove_all(dir / "curves");
  fs::create_directory_symlink(dir.path(), dir / "curves");
  EXPECT_THAT(Refusal(dir / "curves", LockMode::kExclusive), HasSubstr("curves: is a link to"));
}

TEST(OutputLock, DoesNotWaitForAPipe) {
  const TempDir dir;
  ASSERT_EQ(mkfifo((dir / ".lock").c_str(), 0666), 0);
  EXPECT_THAT(Refusal(dir.path(), LockMode::kExclusive), HasSubstr("is not a lock file of limn"));
}

TEST(OutputLock, TellsWhyTheFileCannotBeMade) {
  const TempDir dir;
  fs::create_directories(dir / ".lock");
  EXPECT_THAT(Refusal(dir.path(), LockMode::kExclusive),
              AllOf(HasSubstr((dir / ".lock").string()), HasSubstr("Is a directory")));
}

}  // namespace
}  // namespace limn
