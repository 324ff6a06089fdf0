#include "limn/evaluation/footprint.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

View ViewAt(double z, double focal) {
  View view;
  view.camera = {focal, focal, 50, 50, 101, 101};
  view.region = MakeImageRegion(view.camera, nullptr, {}, 0);
  view.cam_from_world.translation = {0, 0, -z};
  return view;
}

TEST(PixelFootprint, IsTheMedianOfDepthOverFocalLength) {
  const std::vector<View> views = {ViewAt(0, 100), ViewAt(-10, 100), ViewAt(-30, 100)};
  EXPECT_DOUBLE_EQ(PixelFootprint(views, {0, 0, 10}), 0.2);
}

TEST(PixelFootprint, CountsOnlyViewsThatContainThePoint) {
  // The narrow view has the point in front, yet not in its image.
  const std::vector<View> views = {ViewAt(0, 100), ViewAt(0, 1000)};
  EXPECT_DOUBLE_EQ(PixelFootprint(views, {4, 0, 10}), 0.1);
  // If no view contains it, both are asked.
  EXPECT_DOUBLE_EQ(PixelFootprint({ViewAt(0, 1000)}, {4, 0, 10}), 0.01);
}

TEST(PixelFootprint, IsPositiveBehindAllCamerasToo) {
  EXPECT_DOUBLE_EQ(PixelFootprint({ViewAt(0, 100)}, {0, 0, -5}), 0.05);
  EXPECT_GT(PixelFootprint({ViewAt(0, 100)}, {0, 0, 0}), 0);
}

TEST(FootprintOfCurve, IsThatOfItsMiddle) {
  const std::vector<View> views = {ViewAt(0, 100)};
  EXPECT_DOUBLE_EQ(FootprintOfCurve(views, {{0, 0, 10}, {0, 0, 11}, {0, 0, 30}}), 0.2);
  EXPECT_DOUBLE_EQ(FootprintOfCurve(views, {{0, 0, 10}, {0, 0, 10}}), 0.1);
  EXPECT_DOUBLE_EQ(FootprintOfCurve(views, {}), 1);
}

}  // namespace
}  // namespace limn
