// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limn/files/temporary_path.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// In the folder of a file.
int64_t NumFiles(const std::string& path) {
  const std::filesystem::directory_iterator files(std::filesystem::path(path).parent_path());
  return std::distance(begin(files), end(files));
}

void MakeFolder(const WritableFolder& folder, const std::string& name) {
  ASSERT_EQ(mkdirat(folder.descriptor(), name.c_str(), 0777), 0);
}

TEST(WriteFileAtomically, MakesFoldersAndReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a/b/c.bin");
  WriteFileAtomically(path, std::string("first\0one", 9));
  EXPECT_EQ(TemporaryFolder::Read(path), std::string("first\0one", 9));
  WriteFileAtomically(path, "second");
  EXPECT_EQ(TemporaryFolder::Read(path), "second");
  EXPECT_EQ(NumFiles(path), 1);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenWritingFails) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("kept.txt", "old");
  EXPECT_THROW(WriteFileAtomically(path,
                                   [](std::ostream& out) {
                                     out << "half";
                                     throw std::runtime_error("stop");
                                   }),
               std::runtime_error);
  EXPECT_EQ(TemporaryFolder::Read(path), "old");
  EXPECT_EQ(NumFiles(path), 1);
}

TEST(WriteFileAtomically, SaysWhichFileCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("file", "");
  try {
    WriteFileAtomically(file + "/below", "x");
    FAIL() << "a file took the place of a folder";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
}

// Not that the file which it would replace is missing.
TEST(WriteFileAtomically, SaysWhyTheTemporaryFileCannotBeMade) {
  if (!std::filesystem::exists("/sys/kernel")) GTEST_SKIP() << "no folder that takes no file";
  try {
    WriteFileAtomically("/sys/kernel/limn.txt", "text");
    FAIL() << "written";
  } catch (const IoError& error) {
    const std::string reason = error.what();
    EXPECT_EQ(reason.find("/sys/kernel/limn.txt: cannot write: "), 0u) << reason;
    EXPECT_EQ(reason.find("No such file"), std::string::npos) << reason;
  }
}

TEST(WriteFileAtomically, TakesNamesAsLongAsTheyCanBe) {
  const TemporaryFolder folder;
  const std::string path = folder.Path(std::string(255, 'n'));
  WriteFileAtomically(path, "x");
  EXPECT_EQ(TemporaryFolder::Read(path), "x");
}

TEST(WriteFileAtomically, ADiskWithoutRoomIsNamedWithTheFile) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("file");
  try {
    // As a write to a full disk ends, which a test cannot have everywhere.
    WriteFileAtomically(path, [](std::ostream& out) {
      errno = ENOSPC;
      out.setstate(std::ios::badbit);
    });
    FAIL() << "written without room";
  } catch (const IoError& error) {
    EXPECT_EQ(error.what(), path + ": cannot write: No space left on device");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

// What writing there says, which must leave it as it is.
std::string RefusalToWrite(const OutputPath& path) {
  const auto before = std::filesystem::symlink_status(path.string());
  std::string text;
  try {
    WriteFileAtomically(path, "x");
  } catch (const IoError& error) {
    text = error.what();
  }
  EXPECT_EQ(std::filesystem::symlink_status(path.string()).type(), before.type());
  return text;
}

TEST(WriteFileAtomically, PutsNoFileInThePlaceOfDevicesPipesAndFolders) {
  const TemporaryFolder folder;
  const std::string pipe = folder.Path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  std::filesystem::create_symlink("pipe", folder.Path("to-pipe"));
  std::filesystem::create_symlink("/dev/null", folder.Path("to-null"));
  std::filesystem::create_directory(folder.Path("folder"));
  for (const std::string& path :
       {pipe, folder.Path("to-pipe"), folder.Path("to-null"), std::string("/dev/null")}) {
    EXPECT_EQ(RefusalToWrite(path),
              path + ": cannot write: is a device or a pipe, or leads to one, and no file");
  }
  // Whatever standard output is.
  EXPECT_NE(RefusalToWrite("/dev/stdout"), "");
  EXPECT_NE(RefusalToWrite("/proc/self/fd/1"), "");
  EXPECT_EQ(RefusalToWrite(folder.Path("folder")),
            folder.Path("folder") + ": cannot write: is a folder, not a file");
  EXPECT_EQ(NumFiles(pipe), 4);
}

TEST(WriteFileAtomically, ReplacesNoLink) {
  const TemporaryFolder folder;
  const std::string mine = folder.Write("mine", "mine");
  std::filesystem::create_symlink("mine", folder.Path("link"));
  std::filesystem::create_symlink("nowhere", folder.Path("dangling"));
  std::filesystem::create_symlink("loop", folder.Path("loop"));
  for (const char* name : {"link", "dangling", "loop"}) {
    EXPECT_TRUE(
        RefusalToWrite(folder.Path(name)).starts_with(folder.Path(name) + ": is a link to "))
        << name;
  }
  EXPECT_EQ(TemporaryFolder::Read(mine), "mine");
  EXPECT_EQ(NumFiles(mine), 4);
  // The other name keeps the old bytes.
  std::filesystem::create_hard_link(mine, folder.Path("hard"));
  WriteFileAtomically(folder.Path("hard"), "ours");
  EXPECT_EQ(TemporaryFolder::Read(mine), "mine");
}

TEST(WriteFileAtomically, FollowsLinksOnlyToTheFolderThatWasNamed) {
  const TemporaryFolder folder;
  WriteFileAtomically(folder.Path("pictures/mine"), "mine");
  WriteFileAtomically(folder.Path("project/curves/file"), "ours");
  std::filesystem::create_directory_symlink("project", folder.Path("named"));
  std::filesystem::create_directory_symlink("../../pictures", folder.Path("project/curves/link"));
  const OutputPath curves(folder.Path("named"), "curves");
  WriteFileAtomically(curves / "new/file", "new");
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("project/curves/new/file")), "new");
  for (const char* below : {"link/mine", "link/new/file", "link"}) {
    EXPECT_TRUE(RefusalToWrite(curves / below)
                    .starts_with(folder.Path("named/curves/link") +
                                 ": is a link to ../../pictures, and nothing"))
        << below;
  }
  EXPECT_NE(RefusalToWrite(curves / "../../../pictures/mine"), "");
  EXPECT_NE(RefusalToWrite(curves / folder.Path("pictures/mine")), "");
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("pictures/mine")), "mine");
  EXPECT_EQ(NumFiles(folder.Path("pictures/mine")), 1);
}

// A folder is exchanged for a link and back while files are written into it.
TEST(WriteFileAtomically, NoMomentLeadsItThroughALink) {
  const TemporaryFolder folder;
  WriteFileAtomically(folder.Path("other/file"), "mine");
  WriteFileAtomically(folder.Path("out/inner/file"), "ours");
  const auto inner = folder.Path("out/inner"), aside = folder.Path("out/aside");
  std::atomic<bool> is_over = false;
  std::thread exchange([&] {
    while (!is_over) {
      std::error_code ignored;
      std::filesystem::rename(inner, aside, ignored);
      std::filesystem::create_directory_symlink("../other", inner, ignored);
      std::filesystem::remove_all(inner, ignored);
      std::filesystem::rename(aside, inner, ignored);
    }
  });
  const OutputPath file(folder.Path("out"), "inner/file");
  int num_written = 0;
  for (int i = 0; i < 2000; ++i) {
    try {
      WriteFileAtomically(file, "ours");
      ++num_written;
    } catch (const IoError&) {
      continue;  // it met the link
    }
  }
  is_over = true;
  exchange.join();
  EXPECT_GT(num_written, 0);
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("other/file")), "mine");
  EXPECT_EQ(NumFiles(folder.Path("other/file")), 1);
}

TEST(CheckHoldsNoLinks, FindsThemAtAnyDepth) {
  const TemporaryFolder folder;
  WriteFileAtomically(folder.Path("out/curves/cache/sketch/a.bin"), "");
  std::filesystem::create_symlink("/nowhere", folder.Path("out/curves/0123.limn-tmp"));
  const OutputPath curves(folder.Path("out"), "curves");
  CheckHoldsNoLinks(curves);
  CheckHoldsNoLinks(curves / "missing");
  std::filesystem::create_symlink("a.bin", folder.Path("out/curves/cache/sketch/b.bin"));
  EXPECT_THROW(CheckHoldsNoLinks(curves), IoError);
}

TEST(CheckTakesFile, FindsLongNamesAndFilesInPlaceOfFolders) {
  const TemporaryFolder folder;
  CheckTakesFile(folder.Path("new/folder/" + std::string(255, 'n')));
  EXPECT_THROW(CheckTakesFile(folder.Path("new/" + std::string(256, 'n'))), IoError);
  const std::string file = folder.Write("file", "");
  EXPECT_THROW(CheckTakesFile(file + "/new/below"), IoError);
  EXPECT_FALSE(std::filesystem::exists(folder.Path("new")));
}

TEST(WriteFileAtomically, KeepsPermissions) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("secret", "old");
  using std::filesystem::perms;
  std::filesystem::permissions(path, perms::owner_read | perms::owner_write);
  WriteFileAtomically(path, "new");
  EXPECT_EQ(TemporaryFolder::Read(path), "new");
  EXPECT_EQ(std::filesystem::status(path).permissions(), perms::owner_read | perms::owner_write);
}

TEST(AbandonWrites, RemovesTemporaryFilesOfOtherThreads) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("file");
  // In a process of its own: afterwards no file can be written.
  EXPECT_EXIT(
      {
        std::promise<void> begun;
        std::thread writer([&] {
          WriteFileAtomically(path, [&](std::ostream& out) {
            out << "half" << std::flush;
            begun.set_value();
            std::this_thread::sleep_for(std::chrono::hours(1));
          });
        });
        begun.get_future().wait();
        if (NumFiles(path) != 1) _exit(2);
        AbandonWrites();
        _exit(NumFiles(path) == 0 ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(AbandonWrites, RemovesTemporaryFoldersAndKeepsThemFromAppearing) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("model.tmp");
  EXPECT_EXIT(
      {
        const TemporaryPath temporary(path, &MakeFolder);
        std::ofstream half(path + "/images.bin");
        AbandonWrites();
        std::thread([&] {
          WriteFileAtomically(folder.Path("file"), "whole");
          _exit(2);
        }).detach();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        _exit(NumFiles(path) == 0 ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(TemporaryPath, GoesAwayUnlessItIsRenamed) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("model");
  const size_t num_before = NumRenamed();
  for (const bool renames : {false, true}) {
    TemporaryPath temporary(path + ".tmp", &MakeFolder);
    WriteFileAtomically(path + ".tmp/inside", "no result yet");
    EXPECT_EQ(NumRenamed(), num_before);
    if (!renames) continue;
    EXPECT_EQ(temporary.RenameTo("model"), std::error_code());
  }
  EXPECT_EQ(NumFiles(path), 1);
  EXPECT_TRUE(std::filesystem::is_directory(path));
  EXPECT_EQ(NumRenamed(), num_before + 1);
}

}  // namespace
}  // namespace limn
