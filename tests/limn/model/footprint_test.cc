// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/footprint.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

View ViewAt(double z, double focal) {
  View view = testing::ForwardView(101, 101, focal);
  view.cam_from_world.translation = {0, 0, -z};
  return view;
}

DrawingLink LinkOfPoints(const Polyline3d& points, const std::vector<ViewId>& views) {
  DrawingLink link;
  link.points_in_world = points;
  link.supporting_views = views;
  return link;
}

// A step of one footprint across the view moves the image of a point by one pixel.
TEST(FootprintIn, IsTheWidthOfAPixel) {
  View view = ViewAt(-3, 250);
  const Eigen::Vector3d point(1, 2, 7);
  const auto footprint = FootprintIn(view, point);
  ASSERT_TRUE(footprint.has_value());
  view.region.min_px.setConstant(-1e3);
  view.region.max_px.setConstant(1e3);
  const Eigen::Vector2d step =
      *view.Project(point + *footprint * Eigen::Vector3d::UnitX()) - *view.Project(point);
  EXPECT_NEAR(step.norm(), 1, 1e-12);
}

TEST(FootprintIn, IsNothingBehindTheCamera) {
  EXPECT_FALSE(FootprintIn(ViewAt(0, 100), {0, 0, -1}));
  EXPECT_FALSE(FootprintIn(ViewAt(0, 100), {0, 0, 0}));
}

TEST(MedianFootprint, AsksTheGivenViewsOnly) {
  const std::vector<View> views = {ViewAt(0, 100), ViewAt(-10, 100), ViewAt(-30, 100),
                                   ViewAt(20, 100)};
  const Eigen::Vector3d point(0, 0, 10);
  EXPECT_DOUBLE_EQ(MedianFootprint(point, std::vector<ViewId>{0, 1, 2}, views), 0.2);
  EXPECT_DOUBLE_EQ(MedianFootprint(point, std::vector<ViewId>{2}, views), 0.4);
  // The last view has the point behind it.
  EXPECT_DOUBLE_EQ(MedianFootprint(point, std::vector<ViewId>{0, 3}, views), 0.1);
  EXPECT_EQ(MedianFootprint(point, std::vector<ViewId>{3}, views), 0);
}

TEST(LinkFootprint, AsksSupportingViewsFirst) {
  const std::vector<View> views = {ViewAt(0, 100), ViewAt(-10, 100), ViewAt(-30, 100),
                                   ViewAt(20, 100)};
  const Eigen::Vector3d point(0, 0, 10);
  EXPECT_DOUBLE_EQ(LinkFootprint(LinkOfPoints({}, {0}), point, views), 0.1);
  EXPECT_DOUBLE_EQ(LinkFootprint(LinkOfPoints({}, {3}), point, views), 0.2);
  EXPECT_DOUBLE_EQ(LinkFootprint(LinkOfPoints({}, {}), point, views), 0.2);
  EXPECT_EQ(LinkFootprint(LinkOfPoints({}, {0}), {0, 0, -40}, views), 0);
}

TEST(LinkFootprint, OfAWholeLinkIsThatOfItsMiddlePoint) {
  const std::vector<View> views = {ViewAt(0, 100)};
  EXPECT_DOUBLE_EQ(LinkFootprint(LinkOfPoints({{0, 0, 1}, {0, 0, 4}, {0, 0, 90}}, {0}), views),
                   0.04);
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
