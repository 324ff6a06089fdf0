// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/reprojection_errors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

std::vector<ScenePoint> PointsSeenBy(const std::vector<View>& views, int count) {
  std::vector<ScenePoint> points;
  for (int i = 0; i < count; ++i) {
    ScenePoint point;
    point.position_in_world = {0.5 * std::sin(i), 0.5 * std::cos(2 * i), 0.02 * i};
    for (size_t v = 0; v < views.size(); ++v) {
      point.pixels.push_back({static_cast<ViewId>(v), *views[v].Project(point.position_in_world)});
    }
    points.push_back(std::move(point));
  }
  return points;
}

TEST(ReprojectionErrors, AreMediansPerImage) {
  std::vector<View> views = testing::DomeViews(3, 4);
  std::vector<ScenePoint> points = PointsSeenBy(views, 12);
  // Few gross errors do not count; a lens halves the error as it halves the image.
  points[3].pixels[0].position_px.x() += 300;
  for (ScenePoint& point : points) {
    point.pixels[1].position_px.x() += 8;
    point.pixels[1].stored_from_virtual *= 0.5;
  }
  views[2].cam_from_world.rotation =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()) * views[2].cam_from_world.rotation;
  views[2].cam_from_world.translation *= -1;
  const auto errors = MedianReprojectionErrors(views, points, {0, 1, 2});
  EXPECT_NEAR(errors[0].value(), 0, 1e-9);
  EXPECT_NEAR(errors[1].value(), 4, 1e-9);
  EXPECT_EQ(errors[2].value(), 800);  // all behind it
}

TEST(ReprojectionErrors, NeedPoints) {
  const std::vector<View> views = testing::DomeViews(2, 4);
  EXPECT_FALSE(MedianReprojectionErrors(views, PointsSeenBy(views, 9), {0, 1})[0]);
  EXPECT_TRUE(MedianReprojectionErrors(views, PointsSeenBy(views, 10), {0, 1})[0]);
}

TEST(ReprojectionErrors, OfPartsCountTogether) {
  const std::vector<View> views = testing::DomeViews(3, 4);
  std::vector<ScenePoint> points = PointsSeenBy(views, 6);
  for (ScenePoint& point : points) point.pixels[2].position_px.y() += 3;
  const auto errors = MedianReprojectionErrors(views, points, {0, 1, 1});
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_FALSE(errors[0]);
  EXPECT_NEAR(errors[1].value(), 3, 1e-9);  // the upper of the middle two
}

}  // namespace
}  // namespace limn
