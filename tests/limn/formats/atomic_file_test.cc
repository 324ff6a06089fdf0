#include "limn/formats/atomic_file.h"

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <future>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// In the folder of a file.
int64_t NumFiles(const std::string& path) {
  const std::filesystem::directory_iterator files(std::filesystem::path(path).parent_path());
  return std::distance(begin(files), end(files));
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

}  // namespace
}  // namespace limn
