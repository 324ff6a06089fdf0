// SPDX-License-Identifier: BSD-3-Clause
// What wrong cameras do to the images of points and to curves.
#include "limn/cameras/camera_uncertainty.h"

#include <cmath>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "support/pinhole_calibration.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kDistance = 5;
constexpr double kShift = 0.02;
constexpr double kTolerance = 1e-7;

// From the front and from the side.
std::vector<View> TwoViews() {
  return {testing::LookAt({0, -kDistance, 0}, {0, 0, 0}),
          testing::LookAt({kDistance, 0, 0}, {0, 0, 0})};
}

// The first camera may be shifted along its x axis by kShift; the second is held.
CameraUncertainty ShiftedFirst() {
  CameraUncertainty cameras;
  cameras.covariance.matrix = Eigen::MatrixXd::Zero(6, 6);
  cameras.covariance.matrix(3, 3) = kShift * kShift;
  cameras.covariance.body_at = {0, -1};
  cameras.mounts = LooseMounts(2);
  cameras.mounts.held[1] = 1;
  return cameras;
}

// Upright, through the point that both cameras look at.
DrawingGraph UprightLink(double sigma) {
  DrawingGraph graph;
  graph.nodes.resize(2);
  DrawingLink link;
  link.points_in_world = {{0, 0, -0.2}, {0, 0, 0}, {0, 0, 0.2}};
  link.sigma.assign(3, sigma);
  link.supporting_views = {0, 1};
  link.node0 = 0;
  link.node1 = 1;
  graph.nodes[0].position_in_world = link.points_in_world.front();
  graph.nodes[1].position_in_world = link.points_in_world.back();
  graph.links = {link};
  RebuildIncidence(&graph);
  return graph;
}

double ShareOf(const CameraUncertainty& cameras, const std::vector<View>& views) {
  DrawingGraph graph = UprightLink(0);
  AddShareOfCameras(cameras, views, {}, &graph);
  return graph.links[0].sigma[1];
}

TEST(CertainByPx, IsTheMotionOfTheImage) {
  const std::vector<View> views = TwoViews();
  const double shift_px = views[0].camera.fx * kShift / kDistance;
  const Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  // In one of two directions.
  EXPECT_NEAR(CertainByPx(ShiftedFirst(), views, 0, middle), shift_px / std::sqrt(2), kTolerance);
  EXPECT_EQ(CertainByPx(ShiftedFirst(), views, 1, middle), 0);
  EXPECT_EQ(CertainByPx(ShiftedFirst(), views, 0, {0, -2 * kDistance, 0}), 0) << "behind";
}

TEST(CertainByPx, CountsShiftsInTheirUnit) {
  CameraUncertainty cameras = ShiftedFirst();
  cameras.shift_unit = 3;
  const std::vector<View> views = TwoViews();
  EXPECT_NEAR(CertainByPx(cameras, views, 0, {0, 0, 0}),
              3 * CertainByPx(ShiftedFirst(), views, 0, {0, 0, 0}), kTolerance);
}

// A principal point that goes with a turn does not move the image.
TEST(CertainByPx, OpticsThatUndoATurnDoNotCount) {
  std::vector<View> views = TwoViews();
  for (View& view : views) {
    view.calibration = std::make_shared<testing::PinholeCalibration>(view.camera);
  }
  CameraUncertainty cameras = ShiftedFirst();
  cameras.covariance.camera_at = {{views[0].camera_index, 6}};
  cameras.parameters_per_px = {{views[0].camera_index, Eigen::Vector3d::Ones()}};
  // The turn about y by 1 / f px, and the principal point by -1 px.
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(9);
  motion[1] = 1 / views[0].camera.fx;
  cameras.covariance.matrix = motion * motion.transpose();
  EXPECT_NEAR(CertainByPx(cameras, views, 0, {0, 0, 0}), 1 / std::sqrt(2), kTolerance);
  motion[7] = -1;
  cameras.covariance.matrix = motion * motion.transpose();
  EXPECT_NEAR(CertainByPx(cameras, views, 0, {0, 0, 0}), 0, kTolerance);
}

TEST(AddShareOfCameras, CurvesMoveWithTheCamerasThatSeeThem) {
  // As far as the camera, in one of the two directions across.
  EXPECT_NEAR(ShareOf(ShiftedFirst(), TwoViews()), kShift / std::sqrt(2), kTolerance);
}

TEST(AddShareOfCameras, CamerasOnOneBodyMoveTogether) {
  const std::vector<View> views = TwoViews();
  CameraUncertainty cameras = ShiftedFirst();
  cameras.mounts.of_view[1] = {0, views[1].cam_from_world * Inverse(views[0].cam_from_world)};
  // The other camera looks along the shift.
  EXPECT_NEAR(ShareOf(cameras, views), kShift / std::sqrt(2), kTolerance);
  // Along the axis of the first one, hence across that of the other.
  cameras.covariance.matrix.setZero();
  cameras.covariance.matrix(5, 5) = kShift * kShift;
  EXPECT_NEAR(ShareOf(cameras, views), kShift / std::sqrt(2), kTolerance);
}

TEST(AddShareOfCameras, AddsVariances) {
  DrawingGraph graph = UprightLink(kShift);
  AddShareOfCameras(ShiftedFirst(), TwoViews(), {}, &graph);
  EXPECT_NEAR(graph.links[0].sigma[1], kShift * std::sqrt(1.5), kTolerance);
}

TEST(AddShareOfCameras, OneViewDoesNotSayWhereACurveIs) {
  DrawingGraph graph = UprightLink(kShift);
  graph.links[0].supporting_views = {0};
  AddShareOfCameras(ShiftedFirst(), TwoViews(), {}, &graph);
  EXPECT_EQ(graph.links[0].sigma[1], kShift);
}

TEST(EvidenceOfOptics, IsTheMeanSquareInStandardDeviations) {
  CameraCovariance covariance;
  covariance.camera_at = {{4, 1}};
  covariance.matrix = Eigen::Vector4d(9, 4, 0, 1).asDiagonal();
  // The second parameter has no effect.
  EXPECT_NEAR(EvidenceOfOptics(covariance, {{4, Eigen::Vector3d(6, 0, 1)}}), (9 + 1) / 2.0,
              kTolerance);
  EXPECT_EQ(EvidenceOfOptics(covariance, {}), 0);
}

}  // namespace
}  // namespace limn
