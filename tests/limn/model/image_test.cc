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

}  // namespace
}  // namespace limn
