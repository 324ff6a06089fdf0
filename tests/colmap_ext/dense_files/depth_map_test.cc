// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/depth_map.h"

#include <cstring>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

FloatMap MakeMap(int channels) {
  FloatMap map{3, 2, channels, {}};
  for (int i = 0; i < 6 * channels; ++i) map.data.push_back(0.5f * static_cast<float>(i));
  return map;
}

std::string Bytes(const FloatMap& map) {
  std::ostringstream out;
  WriteFloatMap(map, out);
  return out.str();
}

FloatMap Read(const std::string& bytes) {
  std::istringstream in(bytes);
  return ReadFloatMap(in, "map.bin");
}

std::string ErrorOf(const std::string& bytes) {
  return ErrorText<IoError>([&] { Read(bytes); });
}

TEST(DepthMap, LayoutIsThatOfColmap) {
  const std::string bytes = Bytes(MakeMap(1));
  ASSERT_EQ(bytes.substr(0, 6), "3&2&1&");
  ASSERT_EQ(bytes.size(), 6 + 6 * sizeof(float));
  float second_row_first = 0;
  std::memcpy(&second_row_first, bytes.data() + 6 + 3 * sizeof(float), sizeof(float));
  EXPECT_EQ(second_row_first, 1.5f);
}

TEST(DepthMap, RoundTrips) {
  for (const int channels : {1, 3}) {
    const FloatMap map = Read(Bytes(MakeMap(channels)));
    EXPECT_EQ(map.width, 3);
    EXPECT_EQ(map.height, 2);
    EXPECT_EQ(map.channels, channels);
    EXPECT_EQ(map.data, MakeMap(channels).data);
  }
}

TEST(DepthMap, ChannelsArePlanes) {
  const FloatMap map = MakeMap(3);
  EXPECT_EQ(map.At(2, 1), 2.5f);
  EXPECT_EQ(map.At(0, 0, 1), 3.0f);
  EXPECT_EQ(map.At(1, 1, 2), 8.0f);
}

TEST(DepthMap, Case31_DamagedFilesAreRefused) {
  const std::string good = Bytes(MakeMap(1));
  for (size_t size = 0; size < good.size(); ++size) {
    EXPECT_THAT(ErrorOf(good.substr(0, size)), HasSubstr("truncated")) << size;
  }
  EXPECT_THAT(ErrorOf(good + "x"), HasSubstr("1 bytes after"));
  EXPECT_THAT(ErrorOf("<html>"), HasSubstr("the header is not"));
  EXPECT_THAT(ErrorOf("&2&1&"), HasSubstr("the header is not"));
  EXPECT_THAT(ErrorOf("-3&2&1&"), HasSubstr("the header is not"));
  EXPECT_THAT(ErrorOf("3&0&1&"), HasSubstr("height is 0"));
  EXPECT_THAT(ErrorOf("99999999999999999999&2&1&"), HasSubstr("width is too large"));
  EXPECT_THAT(ErrorOf("1000000&1000000&1000000&abcd"), HasSubstr("truncated"));
}

TEST(DepthMap, Case31_FilesKnowTheirKind) {
  const TempDir dir;
  WriteFloatMap(MakeMap(1), dir / "depth.bin");
  WriteFloatMap(MakeMap(3), dir / "normal.bin");
  EXPECT_EQ(ReadDepthMap(dir / "depth.bin").data, MakeMap(1).data);
  EXPECT_EQ(ReadNormalMap(dir / "normal.bin").data, MakeMap(3).data);
  EXPECT_THAT(ErrorText<IoError>([&] { ReadDepthMap(dir / "normal.bin"); }),
              HasSubstr("not a depth map: 3 channels instead of 1"));
  EXPECT_THAT(ErrorText<IoError>([&] { ReadNormalMap(dir / "depth.bin"); }),
              HasSubstr("not a normal map"));
  EXPECT_THROW(ReadDepthMap(dir / "none.bin"), IoError);
  EXPECT_THROW(WriteFloatMap(MakeMap(1), dir / "depth.bin" / "depth.bin"), IoError);
}

}  // namespace
}  // namespace limn::colmap_ext
