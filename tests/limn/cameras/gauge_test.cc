// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/gauge.h"

#include <gtest/gtest.h>

#include "support/camera_errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

Eigen::Affine3d SomeSimilarity() {
  return Eigen::Translation3d(0.1, -0.3, 0.2) *
         Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1.2);
}

TEST(Gauge, MovedViewsSeeTheMovedSceneAsBefore) {
  const std::vector<View> views = testing::DomeViews(5, 4);
  const std::vector<View> moved = Moved(views, SomeSimilarity());
  const Eigen::Vector3d point(0.3, 0.2, -0.1);
  for (size_t v = 0; v < views.size(); ++v) {
    const auto before = views[v].Project(point);
    const auto after = moved[v].Project(SomeSimilarity() * point);
    ASSERT_TRUE(before && after);
    EXPECT_LT((*before - *after).norm(), 1e-9);
  }
}

// Two views: their centers alone would leave a turn about the line between them open.
TEST(Gauge, TwoViewsFixEverything) {
  const std::vector<View> views = testing::DomeViews(2, 4);
  const std::vector<View> moved = Moved(views, SomeSimilarity());
  const Eigen::Affine3d back = FindGauge(views, moved, {0.2, -0.1, 0.3}).given_from_refined;
  EXPECT_LT((back.matrix() - SomeSimilarity().inverse().matrix()).norm(), 1e-9);
}

// Images from one place tell no scale: noise between the centers must not become one.
TEST(Gauge, ViewsOfOneCenterKeepTheScale) {
  std::vector<View> views(3);
  for (int v = 0; v < 3; ++v) {
    views[v].cam_from_world.rotation = Eigen::AngleAxisd(0.3 * v, Eigen::Vector3d::UnitY());
    views[v].cam_from_world.translation =
        views[v].cam_from_world.rotation * Eigen::Vector3d(-1, -2, 1e-12 * v);
  }
  std::vector<View> refined = views;
  refined[2].cam_from_world.translation += Eigen::Vector3d(1e-3, 0, 0);
  const Eigen::Affine3d back = FindGauge(views, refined, {0.5, 0, 4}).given_from_refined;
  EXPECT_LT((back.matrix() - Eigen::Matrix4d::Identity()).norm(), 0.01);
  // The middle is there as well: nothing to go by.
  for (View& view : views) view.cam_from_world.translation.setZero();
  EXPECT_EQ(FindGauge(views, views, Eigen::Vector3d::Zero()).given_from_refined.matrix(),
            Eigen::Matrix4d::Identity());
}

// Images bring a wrong camera back; the world stays with the others, and the camera is named.
TEST(Gauge, FewWrongCamerasDoNotMoveTheWorld) {
  const std::vector<View> right = testing::DomeViews(8, 4);
  std::vector<View> given = right;
  given[2].cam_from_world.translation.x() += 1;
  given[5].cam_from_world.rotation =
      given[5].cam_from_world.rotation * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  given[6].cam_from_world.translation.z() += 10;
  const Gauge gauge = FindGauge(given, Moved(right, SomeSimilarity()), {0.2, -0.1, 0.3});
  EXPECT_LT((gauge.given_from_refined.matrix() - SomeSimilarity().inverse().matrix()).norm(), 1e-9);
  ASSERT_EQ(gauge.moved_far.size(), 3u);
  EXPECT_EQ(gauge.moved_far[0].view, 2);
  EXPECT_NEAR(gauge.moved_far[0].px, 600.0 / 4, 20);
  EXPECT_EQ(gauge.moved_far[1].view, 5);
  EXPECT_EQ(gauge.moved_far[2].view, 6);
  EXPECT_LT(gauge.typical_move_px, 1e-9);
}

// A held camera leaves only the scale open, cameras held at several places nothing.
TEST(Gauge, HeldViewsStay) {
  const std::vector<View> given = testing::DomeViews(8, 4);
  const Eigen::Vector3d center = given[3].CenterInWorld();
  const std::vector<View> refined = Moved(
      given, Eigen::Translation3d(center) * Eigen::Scaling(1.2) * Eigen::Translation3d(-center));
  const Eigen::Vector3d middle(0.2, -0.1, 0.3);
  const Gauge gauge = FindGauge(given, refined, middle, {3});
  EXPECT_LT((gauge.given_from_refined * center - center).norm(), 1e-12);
  EXPECT_LT((gauge.given_from_refined.linear() - Eigen::Matrix3d::Identity() / 1.2).norm(), 1e-9);
  const std::vector<View> back = InGivenFrame(given, refined, gauge, {3});
  for (size_t v = 0; v < given.size(); ++v) {
    EXPECT_LT((back[v].CenterInWorld() - given[v].CenterInWorld()).norm(), 1e-9);
  }
  EXPECT_EQ(back[3].cam_from_world.translation, given[3].cam_from_world.translation);
  EXPECT_EQ(back[3].cam_from_world.rotation.coeffs(), given[3].cam_from_world.rotation.coeffs());
  // Whatever the others do.
  const Gauge of_two = FindGauge(given, Moved(given, SomeSimilarity()), middle, {3, 5});
  EXPECT_EQ(of_two.given_from_refined.matrix(), Eigen::Matrix4d::Identity());
}

// Where all cameras move somewhat, all count.
TEST(Gauge, OrdinaryErrorsAreShared) {
  const std::vector<View> right = testing::DomeViews(24, 4);
  const std::vector<Eigen::Vector3d> corners = testing::CubeCorners(0.8);
  const std::vector<View> given = testing::PerturbCameras(right, corners, 5, 1);
  EXPECT_TRUE(FindGauge(given, right, Eigen::Vector3d::Zero()).moved_far.empty());
}

}  // namespace
}  // namespace limn
