// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/tiff_directory.h"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/image_reader.h"
#include "colmap_ext/workspace/image_traits.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

struct TiffEntry {
  uint16_t tag, type;
  uint32_t count, value;
};

// A little-endian TIFF file, written from its end to its start: what is behind is known.
class TiffWriter {
 public:
  // An uncompressed gray picture. Returns the offset of its directory.
  uint32_t Add(uint32_t width, uint32_t height, char gray, std::vector<TiffEntry> more,
               uint32_t next) {
    const auto data = static_cast<uint32_t>(bytes_.size());
    bytes_.append(static_cast<size_t>(width) * height, gray);
    if (bytes_.size() % 2 == 1) bytes_ += '\0';
    std::vector<TiffEntry> entries = {
        {256, 4, 1, width}, {257, 4, 1, height},         {258, 3, 1, 8}, {259, 3, 1, 1},
        {273, 4, 1, data},  {279, 4, 1, width * height}, {277, 3, 1, 1}, {278, 4, 1, height}};
    if (std::ranges::none_of(more, [](const TiffEntry& e) { return e.tag == 262; })) {
      entries.push_back({262, 3, 1, 1});
    }
    entries.insert(entries.end(), more.begin(), more.end());
    std::ranges::sort(entries, {}, &TiffEntry::tag);
    const auto offset = static_cast<uint32_t>(bytes_.size());
    Put<uint16_t>(static_cast<uint16_t>(entries.size()));
    for (const TiffEntry& entry : entries) {
      Put(entry.tag);
      Put(entry.type);
      Put(entry.count);
      Put(entry.value);
    }
    Put(next);
    return offset;
  }
  std::string File(uint32_t first) const {
    std::string file = bytes_;
    for (int i = 0; i < 4; ++i) file[4 + i] = static_cast<char>(first >> (8 * i));
    return file;
  }

 private:
  template <typename T>
  void Put(T value) {
    for (size_t i = 0; i < sizeof(T); ++i) bytes_ += static_cast<char>(value >> (8 * i));
  }

  std::string bytes_ = std::string("II\x2A\0\0\0\0\0", 8);
};

constexpr uint16_t kSubfileTag = 254, kPhotometricTag = 262, kOrientationTag = 274,
                   kSubDirectoriesTag = 330;

TEST(TiffDirectory, TheLargestPictureOfAChain) {
  TiffWriter tiff;
  const uint32_t page = tiff.Add(6, 4, 9, {}, 0);
  const uint32_t mask = tiff.Add(60, 40, 1, {{kSubfileTag, 4, 1, 4}}, page);
  const uint32_t thumbnail = tiff.Add(3, 2, 5, {{kSubfileTag, 4, 1, 1}}, mask);
  const TempDir dir;
  const std::string path = dir.WriteFile("a.tif", tiff.File(thumbnail));
  EXPECT_EQ(ReadImageSize(path), (ImageSize{6, 4}));
  const Image image = ReadImage(path);
  EXPECT_EQ(image.width, 6);
  EXPECT_THAT(image.data, Each(9));
  // Of equal ones the first.
  TiffWriter pages;
  const uint32_t second = pages.Add(6, 4, 2, {}, 0);
  EXPECT_THAT(ReadImage(dir.WriteFile("b.tif", pages.File(pages.Add(6, 4, 1, {}, second)))).data,
              Each(1));
}

TEST(TiffDirectory, PreviewsInSubDirectories) {
  TiffWriter tiff;
  const uint32_t preview = tiff.Add(6, 4, 7, {{kSubfileTag, 4, 1, 1}}, 0);
  const uint32_t first = tiff.Add(3, 2, 5, {{kSubDirectoriesTag, 4, 1, preview}}, 0);
  const TempDir dir;
  const Image image = ReadImage(dir.WriteFile("a.dng", tiff.File(first)));
  EXPECT_EQ(image.width, 6);
  EXPECT_THAT(image.data, Each(7));
}

TEST(TiffDirectory, RawPicturesMustBeDeveloped) {
  TiffWriter tiff;
  const uint32_t raw = tiff.Add(60, 40, 7, {{kPhotometricTag, 3, 1, 32803}}, 0);
  const uint32_t first = tiff.Add(6, 4, 5, {{kSubDirectoriesTag, 4, 1, raw}}, 0);
  const TempDir dir;
  EXPECT_THAT(ErrorText<IoError>([&] { ReadImageSize(dir.WriteFile("a.dng", tiff.File(first))); }),
              HasSubstr("a.dng: is a raw file"));
  // A preview that is nearly as large stands for it.
  TiffWriter with_preview;
  const uint32_t preview = with_preview.Add(58, 39, 3, {}, 0);
  const uint32_t sensor = with_preview.Add(60, 40, 7, {{kPhotometricTag, 3, 1, 32803}}, preview);
  EXPECT_EQ(ReadImageSize(dir.WriteFile("b.dng", with_preview.File(sensor))), (ImageSize{58, 39}));
}

TEST(TiffDirectory, OrientationsAreLeftToTheReader) {
  const TempDir dir;
  for (uint32_t orientation = 1; orientation <= 8; ++orientation) {
    TiffWriter tiff;
    const uint32_t first = tiff.Add(6, 4, 5, {{kOrientationTag, 3, 1, orientation}}, 0);
    const std::string path = dir.WriteFile("a.tif", tiff.File(first));
    EXPECT_EQ(ReadImage(path).width, 6) << orientation;
    EXPECT_EQ(static_cast<uint32_t>(ReadTraits(std::filesystem::path(path)).orientation),
              orientation);
  }
}

TEST(TiffDirectory, LoopsAndDamageEnd) {
  TiffWriter tiff;
  const uint32_t first = tiff.Add(6, 4, 5, {}, 8 + 24);  // the next is itself
  std::string loop = tiff.File(first);
  EXPECT_EQ(first, 32u);
  std::istringstream in(loop);
  ASSERT_TRUE(LargestTiffDirectory(in));
  for (size_t size = 0; size < loop.size(); ++size) {
    std::istringstream cut(loop.substr(0, size));
    LargestTiffDirectory(cut);
  }
  for (const std::string text : {"", "II", "MM\x2A", "IIIIIIIIIIIIIIIIIIII"}) {
    std::istringstream other(text);
    EXPECT_FALSE(LargestTiffDirectory(other)) << text;
  }
}

}  // namespace
}  // namespace limn::colmap_ext
