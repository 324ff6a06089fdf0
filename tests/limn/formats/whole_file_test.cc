#include "limn/formats/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using testing::HasSubstr;

TEST(WholeFile, IsReadWhateverItsSizeOnDisk) {
  const TempDir dir;
  const std::string text(300'000, 'x');
  EXPECT_EQ(ReadWholeFile(dir.WriteFile("a.txt", text), 10), text);
}

TEST(WholeFile, BombsEndWithALine) {
  const TempDir dir;
  const std::string path = (dir / "bomb.gz").string();
  const gzFile file = gzopen(path.c_str(), "wb");
  const std::string text(300'000, 'x');
  ASSERT_EQ(gzwrite(file, text.data(), 300'000), 300'000);
  gzclose(file);
  EXPECT_EQ(ReadWholeFile(path), text);
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile(path, 100'000); }),
              HasSubstr("bomb.gz: does not end after 100000 bytes"));
}

TEST(WholeFile, DevicesAreNoFiles) {
  EXPECT_THAT(ErrorText<IoError>([&] { ReadWholeFile("/dev/zero"); }),
              HasSubstr("/dev/zero: is a pipe or a device, not a file"));
}

}  // namespace
}  // namespace limn
