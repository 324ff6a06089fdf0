#include "limn/io/atomic_file.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "limn/io/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

TEST(WriteFileAtomically, MakesFoldersAndReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a/b/c.bin");
  WriteFileAtomically(path, std::string("first\0one", 9));
  EXPECT_EQ(TemporaryFolder::Read(path), std::string("first\0one", 9));
  WriteFileAtomically(path, "second");
  EXPECT_EQ(TemporaryFolder::Read(path), "second");
  EXPECT_FALSE(std::filesystem::exists(path + ".tmp"));
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
  EXPECT_FALSE(std::filesystem::exists(path + ".tmp"));
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

}  // namespace
}  // namespace limn
