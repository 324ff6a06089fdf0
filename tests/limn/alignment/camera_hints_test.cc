// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/camera_hints.h"

#include <random>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::AngleDeg;

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

Eigen::Vector3d GravityIn(const View& view) { return -(view.cam_from_world.rotation * kUp); }

// The photograph lies on its side.
void TurnByQuarter(View* view) {
  const Rigid3d quarter = {
      Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())),
      Eigen::Vector3d::Zero()};
  view->cam_from_world = quarter * view->cam_from_world;
}

TEST(CameraHints, CamerasAreHeldUpright) {
  EXPECT_LT(AngleDeg(UpOfCameras(testing::DomeViews(12, 5), {}), kUp), 1);
  // All on one side, looking down by 45 degrees.
  std::vector<View> views;
  for (int i = 0; i < 5; ++i) views.push_back(testing::LookAt({3, i - 2.0, 3}, {0, 0, 0}));
  EXPECT_LT(AngleDeg(UpOfCameras(views, {}), kUp), 30);
  EXPECT_LT(AngleDeg(UpOfCameras({}, {}), -Eigen::Vector3d::UnitY()), 1e-6);
}

TEST(CameraHints, CamerasThatLookStraightDownTellUp) {
  // As a drone flies: forth and back, or in four headings; not quite straight down.
  for (const double tilt : {0.0, -0.01, 0.01}) {
    const int num_headings = tilt == 0 ? 4 : 2;
    std::vector<View> views;
    for (int i = 0; i < 16; ++i) {
      const double heading = 2 * M_PI * i / num_headings;
      View view;
      view.cam_from_world.rotation = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) *
                                     Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()) *
                                     Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ());
      views.push_back(view);
    }
    EXPECT_LT(AngleDeg(UpOfCameras(views, {}), kUp), 1);
    for (View& view : views) {
      view.cam_from_world.rotation = view.cam_from_world.rotation * Eigen::Quaterniond(0, 1, 0, 0);
    }
    EXPECT_LT(AngleDeg(UpOfCameras(views, {}), -kUp), 1);
  }
}

TEST(CameraHints, TheMainViewDirectionIsThatOfMost) {
  std::vector<View> views;
  for (int i = 0; i < 4; ++i) views.push_back(testing::LookAt({3, 0.2 * i - 0.3, 1}, {0, 0, 0}));
  for (int i = 0; i < 7; ++i) views.push_back(testing::LookAt({0.2 * i - 0.6, -3, 0}, {0, 0, 0}));
  EXPECT_LT(AngleDeg(MainViewDirection(views), Eigen::Vector3d::UnitY()), 2);
  // Nearly as many behind them do not change it.
  for (int i = 0; i < 6; ++i) views.push_back(testing::LookAt({0.2 * i - 0.6, 3, 0}, {0, 0, 0}));
  EXPECT_LT(AngleDeg(MainViewDirection(views), Eigen::Vector3d::UnitY()), 2);
}

TEST(CameraHints, QuarterTurnsOfPhotographsAreKnown) {
  std::vector<View> views = testing::DomeViews(12, 5);
  std::vector<ViewPrior> priors(views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    TurnByQuarter(&views[v]);
    priors[v].gravity_in_cam = -Eigen::Vector3d::UnitX();
  }
  EXPECT_LT(AngleDeg(UpOfCameras(views, priors), kUp), 1);
  EXPECT_FALSE(MeasuredUp(views, priors));
}

TEST(CameraHints, MeasuredGravityIsRobust) {
  std::mt19937 random(1);
  const std::vector<View> views = testing::DomeViews(40, 5);
  std::vector<ViewPrior> priors(views.size());
  for (size_t v = 0; v < 30; ++v) {
    priors[v].gravity_in_cam = 9.81 * GravityIn(views[v]) + 0.1 * testing::RandomDirection(&random);
  }
  for (size_t v = 0; v < 5; ++v) priors[v].gravity_in_cam = testing::RandomDirection(&random);
  const auto up = MeasuredUp(views, priors);
  ASSERT_TRUE(up);
  EXPECT_EQ(up->num_views, 30u);
  EXPECT_LT(AngleDeg(up->direction, kUp), 0.5);
  EXPECT_NEAR(up->deviation_rad / kDeg, 0.5, 0.3);
  EXPECT_FALSE(MeasuredUp(views, {}));
}

TEST(CameraHints, GravityThatCancelsTellsNothing) {
  std::vector<ViewPrior> priors(4);
  for (const int v : {0, 2}) {
    priors[v].gravity_in_cam = Eigen::Vector3d(1, 2, 2);
    priors[v + 1].gravity_in_cam = Eigen::Vector3d(-1, -2, -2);
  }
  EXPECT_FALSE(MeasuredUp(std::vector<View>(4), priors));
}

TEST(CameraHints, FewMeasurementsOfGravityTellNothing) {
  const std::vector<View> views = testing::DomeViews(30, 5);
  std::vector<ViewPrior> priors(views.size());
  for (const size_t v : {0, 1}) {
    priors[v].gravity_in_cam = GravityIn(views[v]);
    EXPECT_FALSE(MeasuredUp(views, priors));
  }
  priors[2].gravity_in_cam = -Eigen::Vector3d::UnitX();  // the orientation of a photograph
  EXPECT_FALSE(MeasuredUp(views, priors));
  priors[2].gravity_in_cam = GravityIn(views[2]);
  EXPECT_TRUE(MeasuredUp(views, priors));
}

}  // namespace
}  // namespace limn
