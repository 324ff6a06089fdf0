// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/shrunk.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(Shrunk, PixelsAreMeansOfBlocks) {
  Image image = {5, 4, 1, {}, {}};
  for (int i = 0; i < 20; ++i) image.data.push_back(static_cast<float>(i));
  const Image half = Shrunk(image, 2);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 2);
  // Rows 0 1 / 5 6, and so on; the fifth column is dropped.
  EXPECT_EQ(half.data, (std::vector<float>{3, 5, 13, 15}));
  EXPECT_TRUE(half.mask.empty());
}

TEST(Shrunk, ABlockWithAMaskedPixelIsMasked) {
  Image image = {4, 2, 3, std::vector<float>(24, 8), std::vector<unsigned char>(8, 255)};
  image.mask[5] = 0;
  const Image half = Shrunk(image, 2);
  EXPECT_EQ(half.mask, (std::vector<unsigned char>{0, 255}));
  EXPECT_EQ(half.data, std::vector<float>(6, 8));
}

TEST(Shrunk, TheViewSeesTheSamePlacesInTheSmallPicture) {
  View view;
  view.camera = {500, 480, 320, 240, 640, 480};
  view.region.min_px = {8, 8};
  view.region.max_px = {631, 471};
  const View small = Shrunk(view, 4);
  EXPECT_EQ(small.camera.width, 160);
  const Eigen::Vector3d point(0.3, -0.2, 2);
  const Eigen::Vector2d px = *view.Project(point);
  EXPECT_LT((*small.Project(point) - ShrunkPx(px, 4)).norm(), 1e-12);
  EXPECT_LT((GrownPx(ShrunkPx(px, 4), 4) - px).norm(), 1e-12);
  // The center of the first block of 4 pixels.
  EXPECT_EQ(ShrunkPx({1.5, 1.5}, 4), Eigen::Vector2d(0, 0));
  EXPECT_EQ(small.Project({1.3, 0, 2}).has_value(), view.Project({1.3, 0, 2}).has_value());
}

// Places stay, and a small picture has the pixels of its small photograph.
TEST(Shrunk, PhotographsOfFinerViews) {
  Image image = {12, 14, 1, std::vector<float>(168, 1), {}};
  image.scale.setConstant(1.5);
  View view;
  view.scale = 1.5;
  view.camera = {100, 100, 8.5, 10, image.ViewWidth(), image.ViewHeight()};
  for (const int factor : {2, 4}) {
    const Image small = Shrunk(image, factor);
    const View of_small = Shrunk(view, factor * view.scale);
    EXPECT_EQ(small.width, 12 / factor);
    EXPECT_EQ(small.height, 14 / factor);
    EXPECT_EQ(of_small.camera.width, small.ViewWidth());
    EXPECT_EQ(of_small.camera.height, small.ViewHeight());
    EXPECT_DOUBLE_EQ(of_small.scale, 1.0 / factor);
    const Eigen::Vector2d in_view(4.2, 7);
    const Eigen::Vector2d in_small = ShrunkPx(in_view, factor * view.scale);
    EXPECT_LT((small.FromView(in_small) - ShrunkPx(image.FromView(in_view), factor)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace limn
