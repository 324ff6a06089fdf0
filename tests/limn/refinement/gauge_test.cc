#include "limn/refinement/gauge.h"

#include <gtest/gtest.h>

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
  const Eigen::Affine3d back = GivenFromRefined(views, moved, {0.2, -0.1, 0.3});
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
  const Eigen::Affine3d back = GivenFromRefined(views, refined, {0.5, 0, 4});
  EXPECT_LT((back.matrix() - Eigen::Matrix4d::Identity()).norm(), 0.01);
  // The middle is there as well: nothing to go by.
  for (View& view : views) view.cam_from_world.translation.setZero();
  EXPECT_EQ(GivenFromRefined(views, views, Eigen::Vector3d::Zero()).matrix(),
            Eigen::Matrix4d::Identity());
}

}  // namespace
}  // namespace limn
