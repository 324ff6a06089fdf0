// Scene points that views see badly do not harm.
#include "limn/refinement/pose_fit.h"

#include <atomic>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

const std::vector<View>& PoseViews() {
  static const std::vector<View> views = testing::DomeViews(4, 5);
  return views;
}

// The projection even of what is behind the camera.
Eigen::Vector2d PixelOf(const View& view, const Eigen::Vector3d& point) {
  const Eigen::Vector3d in_cam = view.cam_from_world * point;
  return {view.camera.fx * in_cam.x() / in_cam.z() + view.camera.cx,
          view.camera.fy * in_cam.y() / in_cam.z() + view.camera.cy};
}

// At `place`, but all views see it at the pixels of `seen`.
ScenePoint PointSeenAt(const Eigen::Vector3d& place, const Eigen::Vector3d& seen) {
  ScenePoint point;
  point.position_in_world = place;
  for (int v = 0; v < 4; ++v) {
    point.views.push_back(v);
    point.pixels.push_back({v, PixelOf(PoseViews()[v], seen)});
  }
  return point;
}

struct Fit {
  CameraCorrections corrections = CameraCorrections(PoseViews());
  std::vector<Eigen::Vector3d> positions;
  bool found = false;
};

Fit FitPoints(const std::vector<ScenePoint>& points, const RunContext& context = {}) {
  Fit fit;
  for (const ScenePoint& point : points) fit.positions.push_back(point.position_in_world);
  ControlGraph control;
  fit.found =
      FitPoses(PoseViews(), points, {}, context, &fit.corrections, &control, &fit.positions);
  return fit;
}

TEST(PoseFit, PointsMoveToWhereTheyAreSeen) {
  const Fit fit = FitPoints({PointSeenAt({0.1, 0.1, 0.1}, {0.1, 0.12, 0.1})});
  EXPECT_TRUE(fit.found);
  EXPECT_LT((fit.positions[0] - Eigen::Vector3d(0.1, 0.12, 0.1)).norm(), 1e-3);
}

TEST(PoseFit, PointsWithoutParallaxSayNothing) {
  const Eigen::Vector3d far(0, 0, -1e4);
  ScenePoint point = PointSeenAt(far, {0.1, 0, 0});
  const Fit fit = FitPoints({point});
  EXPECT_EQ(fit.positions[0], far);
  EXPECT_EQ(fit.corrections.motion, CameraCorrections(PoseViews()).motion);
}

TEST(PoseFit, ViewsThatHaveAPointBehindSayNothing) {
  const Eigen::Vector3d behind_first =
      PoseViews()[0].CenterInWorld() +
      Inverse(PoseViews()[0].cam_from_world).rotation * Eigen::Vector3d(0, 0, -0.1);
  ScenePoint point = PointSeenAt(behind_first, {0.1, 0, 0});
  point.pixels.resize(1);
  const Fit fit = FitPoints({point});
  EXPECT_EQ(fit.positions[0], behind_first);
  EXPECT_EQ(fit.corrections.motion, CameraCorrections(PoseViews()).motion);
}

// All other views say that it is behind the first.
TEST(PoseFit, PointsStayInFront) {
  const Rigid3d world_from_cam = Inverse(PoseViews()[0].cam_from_world);
  const Eigen::Vector3d start = world_from_cam * Eigen::Vector3d(0, 0, 0.05);
  ScenePoint point = PointSeenAt(start, world_from_cam * Eigen::Vector3d(0, 0, -0.05));
  point.pixels[0].position_px.x() += 1000;
  const Fit fit = FitPoints({point});
  const View first = Corrected(PoseViews(), fit.corrections)[0];
  EXPECT_GT((first.cam_from_world * fit.positions[0]).z(), 0);
}

TEST(PoseFit, CanBeCancelled) {
  const std::atomic<bool> cancelled = true;
  RunContext context;
  context.cancelled = &cancelled;
  EXPECT_THROW(FitPoints({PointSeenAt({0.1, 0.1, 0.1}, {0.1, 0.12, 0.1})}, context), Cancelled);
}

}  // namespace
}  // namespace limn
