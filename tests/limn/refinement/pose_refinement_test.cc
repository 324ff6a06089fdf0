// Cameras that are off by a pixel come back from the curves of a cube.
#include <cmath>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/refinement/refinement.h"
#include "support/camera_errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSide = 0.8;
constexpr int kNumPoseViews = 16;
constexpr double kNoisePx = 0.2;
constexpr double kErrorPx = 1;

const std::vector<View>& TrueViews() {
  static const std::vector<View> views = testing::DomeViews(kNumPoseViews, 5);
  return views;
}

const std::vector<ImageCurves>& Curves() {
  static const auto curves =
      testing::ProjectCurves(TrueViews(), testing::CubeEdges(kHalfSide), kNoisePx);
  return curves;
}

std::vector<Eigen::Vector3d> PointsOnCube() {
  std::vector<Eigen::Vector3d> points;
  for (const testing::SceneCurve& edge : testing::CubeEdges(kHalfSide)) {
    const Polyline3d samples = ResampleUniform(edge.points, 0.1);
    points.insert(points.end(), samples.begin(), samples.end());
  }
  return points;
}

const std::vector<View>& WrongViews() {
  static const auto views = testing::PerturbCameras(TrueViews(), PointsOnCube(), kErrorPx, 3);
  return views;
}

// The true edges: with wrong cameras they project beside their edgels.
DrawingGraph CubeGraph() {
  const std::vector<Eigen::Vector3d> corners = testing::CubeCorners(kHalfSide);
  DrawingGraph graph;
  graph.nodes.resize(corners.size());
  for (size_t i = 0; i < corners.size(); ++i) graph.nodes[i].position_in_world = corners[i];
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (i & bit) continue;
      DrawingLink link;
      link.points_in_world =
          ResampleUniform(std::vector<Eigen::Vector3d>{corners[i], corners[i | bit]}, 0.01);
      link.sigma.assign(link.points_in_world.size(), 1);
      link.node0 = i;
      link.node1 = i | bit;
      for (int v = 0; v < kNumPoseViews; ++v) link.supporting_views.push_back(v);
      graph.links.push_back(std::move(link));
    }
  }
  RebuildIncidence(&graph);
  return graph;
}

RefinementResult Refine(const std::vector<View>& views, const SceneHints& hints = kNoHints,
                        int num_threads = 2) {
  RefinementOptions options;
  options.refine_poses = true;
  RunContext context;
  context.num_threads = num_threads;
  return RefineDrawing({{views, Curves(), hints}, CubeGraph()}, options, {}, context);
}

testing::CameraErrors ErrorsOf(const std::vector<View>& views) {
  return testing::MeasureCameras(views, TrueViews(), PointsOnCube());
}

// Points on three walls, seen exactly by all true views, at places that are 0.05 off.
std::vector<ScenePoint> WrongPoints() {
  std::vector<ScenePoint> points;
  for (int i = 0; i < 60; ++i) {
    Eigen::Vector3d truth(std::cos(1.7 * i), std::sin(2.9 * i), std::cos(4.3 * i));
    truth[i % 3] = -1;
    ScenePoint point;
    point.position_in_world = truth + 0.05 * Eigen::Vector3d(1, -1, 1);
    for (int v = 0; v < kNumPoseViews; ++v) {
      const auto pixel = TrueViews()[v].Project(truth);
      if (!pixel) continue;
      point.views.push_back(v);
      point.pixels.push_back({v, *pixel});
    }
    points.push_back(std::move(point));
  }
  return points;
}

TEST(PoseRefinement, CamerasComeBackFromCurves) {
  const RefinementResult result = Refine(WrongViews());
  EXPECT_TRUE(Validate(result.graph).empty());
  ASSERT_TRUE(result.cameras);
  const testing::CameraErrors before = ErrorsOf(WrongViews());
  const testing::CameraErrors after = ErrorsOf(result.cameras->views);
  EXPECT_NEAR(before.raw_px, kErrorPx, 0.01);
  // A view sees some 1,000 edgels with noise of 0.2 px.
  EXPECT_LT(after.aligned_px, 0.1);
  EXPECT_LT(after.rotation_deg, before.rotation_deg / 4);
  EXPECT_LT(after.center, before.center / 4);
  // Nothing but the hold at the given cameras says where the world is.
  EXPECT_LT(after.raw_px, before.raw_px);
}

TEST(PoseRefinement, DrawingFitsTheNewCameras) {
  const DrawingGraph graph = Refine(WrongViews()).graph;
  RefinementOptions without;
  const DrawingGraph left =
      RefineDrawing({{WrongViews(), Curves()}, CubeGraph()}, without, {}, {}).graph;
  ASSERT_EQ(graph.links.size(), 12u);
  for (const DrawingLink& link : graph.links) {
    EXPECT_EQ(link.supporting_views.size(), static_cast<size_t>(kNumPoseViews));
    // Median of the size of normal noise: 0.67 sigma.
    EXPECT_LT(link.residual_px, kNoisePx);
  }
  double residual = 0;
  for (const DrawingLink& link : left.links) residual += link.residual_px / 12;
  EXPECT_GT(residual, kNoisePx);
}

TEST(PoseRefinement, FocalLengthComesBackFromCurves) {
  std::vector<View> views = TrueViews();
  for (View& view : views) view.camera.fx = view.camera.fy = 603;
  const RefinementResult result = Refine(views);
  for (const View& view : result.cameras->views) EXPECT_NEAR(view.camera.fx, 600, 1);
  EXPECT_LT(ErrorsOf(result.cameras->views).aligned_px, 0.1);
}

TEST(PoseRefinement, OnlyViewsOfOneCameraShareItsFocalLength) {
  std::vector<View> views = TrueViews();
  for (int v = 0; v < kNumPoseViews; ++v) {
    views[v].camera_index = v % 2 == 0 ? 7 : 3;
    if (v % 2 == 0) views[v].camera.fx = views[v].camera.fy = 604;
  }
  const std::vector<View> refined = Refine(views).cameras->views;
  for (int v = 2; v < kNumPoseViews; ++v) {
    EXPECT_EQ(refined[v].camera.fx, refined[v - 2].camera.fx);
  }
  EXPECT_NEAR(refined[0].camera.fx, refined[1].camera.fx, 1.5);
}

TEST(PoseRefinement, PointsMoveToWhereTheViewsSeeThem) {
  const std::vector<ScenePoint> points = WrongPoints();
  const RefinementResult result = Refine(WrongViews(), {points});
  ASSERT_EQ(result.cameras->points.size(), points.size());
  EXPECT_LT(ErrorsOf(result.cameras->views).aligned_px, 0.1);
  for (size_t p = 0; p < points.size(); ++p) {
    for (const PointPixel& pixel : points[p].pixels) {
      const auto seen = result.cameras->views[pixel.view].Project(result.cameras->points[p]);
      ASSERT_TRUE(seen);
      EXPECT_LT((*seen - pixel.position_px).norm(), 0.3);
    }
  }
}

// The world is held where the scene is, not where a few points are.
TEST(PoseRefinement, PointsFarAwayDoNotMoveTheWorld) {
  std::vector<ScenePoint> points = WrongPoints();
  const double without = ErrorsOf(Refine(WrongViews(), {points}).cameras->views).raw_px;
  for (int i = 0; i < 5; ++i) {
    points.push_back(points[i]);
    points.back().position_in_world = {1e5, 2e5, 0};
  }
  const double with = ErrorsOf(Refine(WrongViews(), {points}).cameras->views).raw_px;
  EXPECT_LT(with, 1.2 * without);
}

// Without any curve the points alone determine the cameras.
TEST(PoseRefinement, PointsAloneBringCamerasBack) {
  RefinementOptions options;
  options.refine_poses = true;
  const DrawingGraph empty;
  const RefinementResult result =
      RefineDrawing({{WrongViews(), Curves(), {WrongPoints()}}, empty}, options, {}, {});
  EXPECT_LT(ErrorsOf(result.cameras->views).aligned_px, 0.1);
}

// The camera is repaired and named; the world is where the others hold it.
TEST(PoseRefinement, OneWrongCameraDoesNotMoveTheWorld) {
  std::vector<View> views = TrueViews();
  views[3].cam_from_world.translation.x() += 0.3;
  const std::vector<ScenePoint> points = WrongPoints();
  const RefinementResult result = Refine(views, {points});
  EXPECT_LT(ErrorsOf(result.cameras->views).raw_px, 0.2);
  ASSERT_EQ(result.summary.warnings.size(), 1u);
  EXPECT_NE(result.summary.warnings[0].find(views[3].name + " ("), std::string::npos);
}

TEST(PoseRefinement, RightCamerasStay) {
  const RefinementResult result = Refine(TrueViews());
  EXPECT_LT(ErrorsOf(result.cameras->views).raw_px, 0.1);
}

TEST(PoseRefinement, ResultDoesNotDependOnThreads) {
  const RefinementResult one = Refine(WrongViews(), kNoHints, 1);
  const RefinementResult two = Refine(WrongViews(), kNoHints, 2);
  for (int v = 0; v < kNumPoseViews; ++v) {
    EXPECT_EQ(one.cameras->views[v].cam_from_world.translation,
              two.cameras->views[v].cam_from_world.translation);
  }
  EXPECT_EQ(one.graph.links[0].points_in_world, two.graph.links[0].points_in_world);
}

TEST(PoseRefinement, OffGivesNoCameras) {
  const RefinementResult result =
      RefineDrawing({{WrongViews(), Curves()}, CubeGraph()}, {}, {}, {});
  EXPECT_FALSE(result.cameras);
}

}  // namespace
}  // namespace limn
