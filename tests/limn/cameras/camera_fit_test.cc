// SPDX-License-Identifier: BSD-3-Clause
// How far a camera follows what a few curves, or many, say of it.
#include "limn/cameras/camera_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kFromMiddle = 5;
constexpr int kNumPoints = 40;

// The first may move.
const std::vector<View>& DomeOfSix() {
  static const auto views = testing::DomeViews(6, kFromMiddle);
  return views;
}

CameraMounts FirstIsFree() {
  CameraMounts mounts = LooseMounts(DomeOfSix().size());
  for (size_t v = 1; v < DomeOfSix().size(); ++v) mounts.held[v] = 1;
  return mounts;
}

// Points where the held views see them; the first sees them `off_px` beside.
std::vector<Landmark> Landmarks(double off_px, double weight_of_first) {
  std::vector<Landmark> landmarks;
  for (int i = 0; i < kNumPoints; ++i) {
    Landmark landmark;
    landmark.position = {std::cos(1.7 * i), std::sin(2.9 * i), 0.5 * std::cos(4.3 * i)};
    landmark.ways = 0.01 * Eigen::Matrix3d::Identity();
    landmark.robust_px = 100;
    landmark.curve = i;
    for (size_t v = 0; v < DomeOfSix().size(); ++v) {
      const Eigen::Vector2d pixel =
          *DomeOfSix()[v].Project(landmark.position) + Eigen::Vector2d(v == 0 ? off_px : 0, 0);
      for (const int axis : {0, 1}) {
        landmark.lines.push_back({static_cast<ViewId>(v),
                                  EdgelLine(pixel, Eigen::Vector2d::Unit(axis)),
                                  v == 0 ? weight_of_first : 100});
      }
    }
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

// Of the images of the points in the first view, along x.
double MovedPx(double off_px, double weight_of_first) {
  const CameraMounts mounts = FirstIsFree();
  CameraFitInput input = {DomeOfSix(), mounts, {}, {}, {}};
  for (const View& view : DomeOfSix()) {
    input.given_poses.push_back(view.cam_from_world);
    input.distances.push_back(kFromMiddle);
  }
  std::vector<Landmark> landmarks = Landmarks(off_px, weight_of_first);
  const auto fit = FitCameras(input, {}, &landmarks);
  if (!fit) return NAN;
  View moved = DomeOfSix()[0];
  moved.cam_from_world = fit->body_poses[0];
  double sum = 0;
  for (const Landmark& landmark : landmarks) {
    sum += moved.Project(landmark.position)->x() - DomeOfSix()[0].Project(landmark.position)->x();
  }
  return sum / kNumPoints;
}

TEST(FitCameras, ACameraFollowsWhatManyCurvesSay) { EXPECT_NEAR(MovedPx(10, 1), 10, 0.1); }

// The farther, the less it is held: by squares it would end 5 px short.
TEST(FitCameras, ALostCameraIsFree) { EXPECT_NEAR(MovedPx(60, 0.2 / kNumPoints), 60, 2); }

TEST(FitCameras, ACameraStaysNearWhereItWasIfFewCurvesDisagree) {
  const double little = 0.002 / kNumPoints;  // of all points, 1 / px^2
  EXPECT_GT(MovedPx(10, little), 0.1);
  EXPECT_LT(MovedPx(10, little), 2);
}

}  // namespace
}  // namespace limn
