// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/image_polylines_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Eigen::Vector2d;
using ::testing::ElementsAre;

TEST(ImagePolylines, SegmentsAndCurvesAreLines) {
  const TemporaryFolder folder;
  const auto read = ReadImagePolylines(
      folder.Write("a.txt", "# segments\n1 2 3.5 2\n\n  0,0, 5,0, 5,5, 0,0\r\n-1 -1 64 48\n"), 64,
      48);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_THAT(read[0], ElementsAre(Vector2d(1, 2), Vector2d(3.5, 2)));
  EXPECT_THAT(read[1], ElementsAre(Vector2d(0, 0), Vector2d(5, 0), Vector2d(5, 5), Vector2d(0, 0)));
  EXPECT_THAT(read[2], ElementsAre(Vector2d(-1, -1), Vector2d(64, 48)));
  EXPECT_TRUE(ReadImagePolylines(folder.Write("none.txt", "# nothing\n"), 64, 48).empty());
}

TEST(ImagePolylines, WhatIsNoCurveIsRefusedByLine) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& line) {
    const std::string path = folder.Write("a.txt", "1 1 2 2\n" + line + "\n");
    try {
      ReadImagePolylines(path, 8, 6);
    } catch (const IoError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return std::string();
  };
  EXPECT_EQ(error_of("1 1 2"), ": line 2: x without y");
  EXPECT_EQ(error_of("1 1"), ": line 2: a curve without length");
  EXPECT_EQ(error_of("1 1 1 1"), ": line 2: a curve without length");
  EXPECT_EQ(error_of("0 0 1e-17 0"), ": line 2: a curve without length");
  EXPECT_EQ(error_of("1 1 2 b"), ": line 2: y expected, not \"b\"");
  EXPECT_EQ(error_of("1 1 2 nan"), ": line 2: y is not finite");
  EXPECT_EQ(error_of("1 1 8.5 2"), ": line 2: point outside the image of 8 x 6 pixels");
  EXPECT_EQ(error_of("1 1 2 1e200"), ": line 2: point outside the image of 8 x 6 pixels");
  EXPECT_EQ(error_of("0 0 8 0 0 0 8 0 0 0 8 0 0 0"),
            ": line 2: curves longer than the image has pixels");
}

}  // namespace
}  // namespace limn
