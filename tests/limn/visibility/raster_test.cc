// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

DepthImage SquareImage(int size) {
  DepthImage image;
  image.width = image.height = size;
  image.depth.assign(static_cast<size_t>(size) * size, 0);
  return image;
}

TEST(Raster, TellsHowManyPixelsItLookedAt) {
  DepthImage image = SquareImage(10);
  const auto depth = [](const Eigen::Vector2d&) { return 1.0; };
  // Four rows with four pixels each.
  EXPECT_EQ(FillPolygon({{2, 2}, {5, 2}, {5, 5}, {2, 5}}, depth, &image), 4u + 16u);
  EXPECT_EQ(FillPolygon({{20, 20}, {30, 20}, {30, 30}}, depth, &image), 0u);
  EXPECT_EQ(FillDisc({4, 4}, 1, 1, &image), 9u);
  EXPECT_EQ(FillDisc({40, 4}, 1, 1, &image), 0u);
}

TEST(RasterWork, EndsAfterAHundredLayers) {
  constexpr size_t kPixels = 2000 * 2000;
  RasterWork work(SquareImage(2000), /*num_items=*/101);
  for (int layer = 0; layer < 100; ++layer) work.Add(kPixels);
  EXPECT_THAT([&] { work.Add(kPixels); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("a hundred times over")));
}

TEST(RasterWork, SmallPicturesAndManySmallItemsMayTakeMore) {
  RasterWork little(SquareImage(10), 1);
  EXPECT_NO_THROW(little.Add(100'000'000));
  RasterWork many(SquareImage(10), 10'000'000);
  EXPECT_NO_THROW(many.Add(500'000'000));
}

}  // namespace
}  // namespace limn
