// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/joint_rays.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using testing::FrontalPoint;
using testing::FrontalScene;
using testing::kFrontalPx;
using testing::PxSegment;

// Four views, a few px, edgels without errors.
constexpr double kExactRad = 1 * kDeg;

double AngleTo(const JointDirection& found, const Eigen::Vector3d& direction) {
  return std::acos(std::min(found.unit.dot(direction.normalized()), 1.0));
}

const Eigen::Vector3d& Origin() {
  static const Eigen::Vector3d origin = FrontalPoint(0, 0);
  return origin;
}

// A link from the origin along the x axis, and an edge to an offset, px, in the views given.
FrontalScene CornerJoint(const Eigen::Vector3d& edge_px, const std::vector<ViewId>& in_views) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  scene.ShowInSpace({Origin(), kFrontalPx * edge_px}, in_views);
  return scene;
}
FrontalScene CornerJoint(const Eigen::Vector3d& edge_px) {
  return CornerJoint(edge_px, FrontalScene().AllViews());
}

TEST(FindJointDirectionTest, DirectionOfAnEdgeIsFound) {
  for (const Eigen::Vector3d& edge : std::vector<Eigen::Vector3d>{
           {0, 30, 0}, {0, -30, 0}, {-30, 0, 0}, {20, 25, 0}, {0, 20, 20}, {-20, 10, -20}}) {
    FrontalScene scene = CornerJoint(edge);
    const auto found = scene.DirectionAt(Origin(), 4);
    ASSERT_TRUE(found) << edge.transpose();
    EXPECT_NEAR(found->unit.norm(), 1, 1e-9);
    EXPECT_LT(AngleTo(*found, edge), kExactRad) << edge.transpose();
  }
}

TEST(FindJointDirectionTest, ViewsWhoseRaysAgreeAreTold) {
  const std::vector<ViewId> some = {0, 3, 6, 9, 10, 12, 15};
  FrontalScene scene = CornerJoint({0, 30, 0}, some);
  const auto found = scene.DirectionAt(Origin(), 4);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->views, some);
}

TEST(FindJointDirectionTest, EnoughViewsMustAgree) {
  FrontalScene scene = CornerJoint({0, 30, 0}, {0, 2, 5, 7, 9});
  EXPECT_TRUE(scene.DirectionAt(Origin(), 5));
  EXPECT_FALSE(scene.DirectionAt(Origin(), 6));
}

TEST(FindJointDirectionTest, ViewsThatDoNotSeeTheCornerAreNotAsked) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0), {0, 2, 5, 7});
  scene.Show(PxSegment(0, 0, 0, 30));
  const auto found = scene.DirectionAt(Origin(), 4);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->views, (std::vector<ViewId>{0, 2, 5, 7}));
}

TEST(FindJointDirectionTest, WhatALinkExplainsIsNoNewDirection) {
  const auto found = [](double angle_deg) {
    const double angle = angle_deg * kDeg;
    FrontalScene scene = CornerJoint({30 * std::cos(angle), 30 * std::sin(angle), 0});
    return scene.DirectionAt(Origin(), 4).has_value();
  };
  EXPECT_FALSE(found(0));
  EXPECT_FALSE(found(14));
  EXPECT_TRUE(found(30));
  EXPECT_TRUE(found(180));
}

TEST(FindJointDirectionTest, TwoViewsGiveTheDirectionAndItsSign) {
  for (const double sign : {-1.0, 1.0}) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, 0, 60, 0), {0, 7});
    scene.Show(PxSegment(0, 0, 0, 30 * sign));
    const auto found = scene.DirectionAt(Origin(), 2);
    ASSERT_TRUE(found);
    EXPECT_LT(AngleTo(*found, {0, sign, 0}), kExactRad);
  }
}

TEST(FindJointDirectionTest, MoreViewsWin) {
  // Whether they come first or last.
  const auto found = [](const std::vector<ViewId>& few, ViewId begin, ViewId end) {
    FrontalScene scene = CornerJoint({0, 30, 0}, few);
    scene.ShowInSpace({Origin(), FrontalPoint(-20, -20)}, scene.Views(begin, end));
    return scene.DirectionAt(Origin(), 4);
  };
  for (const auto& direction : {found({0, 2, 5, 7, 8}, 4, 16), found({7, 8, 10, 13, 15}, 0, 12)}) {
    ASSERT_TRUE(direction);
    EXPECT_LT(AngleTo(*direction, {-1, -1, 0}), kExactRad);
  }
}

TEST(FindJointDirectionTest, EdgesThatPassByAreNoRays) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  scene.Show(PxSegment(-4, -30, -4, 30));
  EXPECT_FALSE(scene.DirectionAt(Origin(), 4));
}

TEST(FindJointDirectionTest, EdgesThatDoNotMeetInSpaceAreNoDirection) {
  // In every view an edge leaves the corner in another direction: 24 degrees from one to the next,
  // twice the width in which they agree.
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  for (ViewId v = 0; v < 12; ++v) {
    const double angle = (36 + 24 * v) * kDeg;
    scene.Show(PxSegment(0, 0, 30 * std::cos(angle), 30 * std::sin(angle)), {v});
  }
  EXPECT_FALSE(scene.DirectionAt(Origin(), 4));
}

TEST(FindJointDirectionTest, ShortEdgesAreRaysToo) {
  FrontalScene scene = CornerJoint({0, 6, 0});
  EXPECT_TRUE(scene.DirectionAt(Origin(), 4));
  // What ends where edges are rounded says nothing.
  FrontalScene tiny = CornerJoint({0, 3, 0});
  EXPECT_FALSE(tiny.DirectionAt(Origin(), 4));
}

}  // namespace
}  // namespace limn
