// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/image.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const Image kGray = {2, 2, 1, {0, 10, 20, 50}, {}};

TEST(ColorAt, IsBilinearBetweenCentersOfPixels) {
  EXPECT_EQ(ColorAt(kGray, {1, 1}), Eigen::Vector3f::Constant(50));
  EXPECT_EQ(ColorAt(kGray, {0.5, 0}), Eigen::Vector3f::Constant(5));
  EXPECT_EQ(ColorAt(kGray, {0, 0.25}), Eigen::Vector3f::Constant(5));
  EXPECT_EQ(ColorAt(kGray, {0.5, 0.5}), Eigen::Vector3f::Constant(20));
}

TEST(ColorAt, BeyondTheBorderIsThatOfTheBorder) {
  EXPECT_EQ(ColorAt(kGray, {-3, 0.5}), Eigen::Vector3f::Constant(10));
  EXPECT_EQ(ColorAt(kGray, {7, 9}), Eigen::Vector3f::Constant(50));
}

TEST(ColorAt, HasTheThreeChannelsOfAPhotograph) {
  const Image two_pixels = {2, 1, 3, {1, 2, 3, 5, 10, 15}, {}};
  EXPECT_EQ(ColorAt(two_pixels, {0.5, 0}), Eigen::Vector3f(3, 6, 9));
}

// The corners of the photograph are those of the view.
TEST(Image, PlacesInTheViewAndInThePhotograph) {
  Image image = {4, 2, 1, std::vector<float>(8, 0), {}};
  image.scale = {1.5, 2};
  EXPECT_EQ(image.ViewWidth(), 6);
  EXPECT_EQ(image.ViewHeight(), 4);
  EXPECT_LT((image.ToView({-0.5, 1.5}) - Eigen::Vector2d(-0.5, 3.5)).norm(), 1e-12);
  EXPECT_LT((image.FromView(image.ToView({0.7, 1.2})) - Eigen::Vector2d(0.7, 1.2)).norm(), 1e-12);
}

TEST(AtViewSize, InterpolatesBetweenPixels) {
  Image image = kGray;
  image.scale = {2, 1};
  const Image enlarged = AtViewSize(image);
  EXPECT_EQ(enlarged.width, 4);
  EXPECT_EQ(enlarged.height, 2);
  EXPECT_TRUE(enlarged.scale.isOnes());
  EXPECT_EQ(enlarged.data, (std::vector<float>{0, 2.5, 7.5, 10, 20, 27.5, 42.5, 50}));
}

}  // namespace
}  // namespace limn
