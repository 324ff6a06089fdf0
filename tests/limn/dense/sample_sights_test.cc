// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/sample_sights.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "limn/dense/plate_scene.h"

namespace limn {
namespace {

using testing::kPlateHalf;
using testing::kPlatePx;

SampleSight LookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& tangent) {
  const View& view = testing::PlateViews()[0];
  return LookAtSample(view, *testing::PlateDepths()(0), position, tangent, {});
}

TEST(SampleSights, OnAboveAndBelowThePlate) {
  EXPECT_EQ(LookAt({0.1, 0.1, 0}, {1, 0, 0}).sight, Sight::kVisible);
  EXPECT_EQ(LookAt({0, 0, 0.15}, {1, 0, 0}).sight, Sight::kVisible);
  EXPECT_EQ(LookAt({0, 0, -0.15}, {1, 0, 0}).sight, Sight::kOccluded);
  // The tolerance is of five pixels in depth, and what a slope may make of the nine cells.
  EXPECT_EQ(LookAt({0.1, 0.1, -2 * kPlatePx}, {1, 0, 0}).sight, Sight::kVisible);
  // Not in the image.
  EXPECT_EQ(LookAt({9, 0, 0}, {1, 0, 0}).sight, Sight::kUnknown);
}

TEST(SampleSights, SidesOfPaintAndRim) {
  const SampleSight paint = LookAt({0.1, 0.1, 0}, {1, 0, 0});
  for (const int s : {0, 1}) {
    EXPECT_EQ(paint.sides[s], Side::kNear);
    ASSERT_TRUE(paint.normals[s]);
    EXPECT_GT(paint.normals[s]->z(), 0.999);
  }
  EXPECT_TRUE(paint.touches);
  // Walking along x at the rim y = h the plate is on the side of smaller y.
  const SampleSight rim = LookAt({0, kPlateHalf, 0}, {1, 0, 0});
  EXPECT_EQ((rim.sides[0] == Side::kNear) + (rim.sides[1] == Side::kNear), 1);
  const SampleSight air = LookAt({0, 0, 0.15}, {1, 0, 0});
  EXPECT_EQ(air.sides[0], Side::kBehind);
  EXPECT_EQ(air.sides[1], Side::kBehind);
  EXPECT_FALSE(air.touches);
}

TEST(SampleSights, AStrayDepthInFrontHidesNothing) {
  const View& view = testing::PlateViews()[0];
  DepthImage image = *testing::PlateDepths()(0);
  std::fill(image.depth.begin(), image.depth.end(), 0.f);
  const Eigen::Vector3d point(0.1, 0.1, 0);
  const Eigen::Vector2i cell = image.CellAt(*view.Project(point));
  image.depth[image.Index(cell.x(), cell.y())] = 3;
  EXPECT_EQ(LookAtSample(view, image, point, {1, 0, 0}, {}).sight, Sight::kUnknown);
  for (const int dx : {-1, 1}) image.depth[image.Index(cell.x() + dx, cell.y())] = 3;
  EXPECT_EQ(LookAtSample(view, image, point, {1, 0, 0}, {}).sight, Sight::kOccluded);
}

}  // namespace
}  // namespace limn
