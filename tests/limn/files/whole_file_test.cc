// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "colmap_ext/temp_dir.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;

TEST(WholeFile, LargerFilesThanWantedAreNotRead) {
  const TempDir dir;
  const std::string text(300'000, 'x');
  const std::string path = dir.WriteFile("a.txt", text);
  EXPECT_EQ(ReadWholeFile(path, text.size()), text);
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile(path, text.size() - 1); }),
              HasSubstr("a.txt: has 300000 bytes, at most 299999 are read"));
  std::filesystem::resize_file(path, uintmax_t{100} << 30);  // sparse
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile(path); }), HasSubstr("at most 4294967296"));
}

// A scene in tiles has a drawing.json of gigabytes.
TEST(WholeFile, DrawingsMayBeAsLargeAsMeshes) {
  const TempDir dir;
  const std::string path = dir.WriteFile("drawing.json", "{");
  std::filesystem::resize_file(path, kMaxMeshBytes + 1);  // sparse
  EXPECT_THAT(ErrorText<IoError>([&] { ReadDrawingJson(path); }),
              HasSubstr("at most 17179869184 are read"));
}

TEST(WholeFile, BombsEndWithALine) {
  const TempDir dir;
  const std::string path = (dir / "bomb.gz").string();
  const gzFile file = gzopen(path.c_str(), "wb");
  const std::string text(1 << 20, 'x');
  for (int i = 0; i < 65; ++i) ASSERT_EQ(gzwrite(file, text.data(), 1 << 20), 1 << 20);
  gzclose(file);
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile(path, 100'000); }),
              HasSubstr("bomb.gz: does not end after 100000 bytes"));
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile(path); }),
              HasSubstr("bomb.gz: does not end after 67108864 bytes"));
}

TEST(OpenFile, OpensRegularFilesOnly) {
  const TempDir dir;
  std::string line;
  std::ifstream in = OpenFile(dir.WriteFile("a.txt", "text"));
  EXPECT_TRUE(std::getline(in, line));
  EXPECT_EQ(line, "text");
  EXPECT_THAT(ErrorText<IoError>([&] { OpenFile((dir / "none").string()); }),
              HasSubstr("none: cannot be opened for reading"));
  EXPECT_THAT(ErrorText<IoError>([] { OpenFile("/dev/zero"); }),
              HasSubstr("/dev/zero: is a pipe or a device, not a file"));
}

TEST(WholeFile, DevicesAreNoFiles) {
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile("/dev/zero"); }),
              HasSubstr("/dev/zero: is a pipe or a device, not a file"));
}

}  // namespace
}  // namespace limn
