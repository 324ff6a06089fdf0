// SPDX-License-Identifier: BSD-3-Clause
// Cameras that are off by a pixel come back from the curves of a cube.
#include "limn/cameras/camera_rounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <memory>

#include <gtest/gtest.h>

#include "limn/cameras/gauge.h"
#include "limn/geometry/polyline.h"
#include "limn/model/curves_scene.h"
#include "limn/util/errors.h"
#include "support/camera_errors.h"
#include "support/pinhole_calibration.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Of cubes, one in the other.
constexpr double kHalfSides[] = {0.8, 0.55, 0.35};
constexpr int kNumPoseViews = 16;
constexpr double kNoisePx = 0.2;
constexpr double kErrorPx = 1;

const std::vector<View>& TrueViews() {
  static const std::vector<View> views = testing::DomeViews(kNumPoseViews, 5);
  return views;
}

std::vector<testing::SceneCurve> CubeEdges() {
  std::vector<testing::SceneCurve> edges;
  for (const double half_side : kHalfSides)
    std::ranges::move(testing::CubeEdges(half_side), std::back_inserter(edges));
  return edges;
}

const std::vector<ImageCurves>& Curves() {
  static const auto curves = testing::ProjectCurves(TrueViews(), CubeEdges(), kNoisePx);
  return curves;
}

CameraRoundsResult Refine(const CameraRoundsInput& input, const std::vector<ImageCurves>& curves,
                          CameraScene* scene, const RunContext& context = {}) {
  PictureLevel level = {1, curves};
  return RefineCamerasByDrawing(input, {}, context, &level, scene);
}

std::vector<Eigen::Vector3d> PointsOnCube() {
  std::vector<Eigen::Vector3d> points;
  for (const testing::SceneCurve& edge : CubeEdges()) {
    const Polyline3d samples = ResampleUniform(edge.points, 0.1);
    points.insert(points.end(), samples.begin(), samples.end());
  }
  return points;
}

const std::vector<View>& WrongViews() {
  static const auto views = testing::PerturbCameras(TrueViews(), PointsOnCube(), kErrorPx, 3);
  return views;
}

void AddCube(double half_side, DrawingGraph* graph) {
  const auto first = static_cast<int>(graph->nodes.size());
  const std::vector<Eigen::Vector3d> corners = testing::CubeCorners(half_side);
  graph->nodes.resize(first + corners.size());
  for (int i = 0; i < 8; ++i) {
    graph->nodes[first + i].position_in_world = corners[i];
    for (const int bit : {1, 2, 4}) {
      if (i & bit) continue;
      DrawingLink link;
      link.points_in_world =
          ResampleUniform(std::vector<Eigen::Vector3d>{corners[i], corners[i | bit]}, 0.01);
      link.sigma.assign(link.points_in_world.size(), 1);
      link.node0 = first + i;
      link.node1 = first + (i | bit);
      for (int v = 0; v < kNumPoseViews; ++v) link.supporting_views.push_back(v);
      graph->links.push_back(std::move(link));
    }
  }
}

// The true edges: with wrong cameras they project beside their edgels.
DrawingGraph CubeGraph() {
  DrawingGraph graph;
  for (const double half_side : kHalfSides) AddCube(half_side, &graph);
  RebuildIncidence(&graph);
  return graph;
}

CameraScene Refine(const std::vector<View>& views, const SceneHints& hints = kNoHints,
                   int num_threads = 2, const DrawingGraph& graph = CubeGraph()) {
  RunContext context;
  context.num_threads = num_threads;
  CameraScene scene = MakeCameraScene(views, hints, LooseMounts(views.size()));
  Refine({graph, {3, 2}, {1, 1, 1}}, Curves(), &scene, context);
  return scene;
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

TEST(CameraRounds, CamerasComeBackFromCurves) {
  const testing::CameraErrors before = ErrorsOf(WrongViews());
  const testing::CameraErrors after = ErrorsOf(Refine(WrongViews()).views);
  EXPECT_NEAR(before.raw_px, kErrorPx, 0.01);
  // A view sees some 1,000 edgels with noise of 0.2 px.
  EXPECT_LT(after.aligned_px, 0.1);
  EXPECT_LT(after.rotation_deg, before.rotation_deg / 4);
  EXPECT_LT(after.center, before.center / 4);
  // Nothing but the hold at the given cameras says where the world is.
  EXPECT_LT(after.raw_px, before.raw_px);
}

std::vector<View> WithOpticsOff(std::vector<View> views, int first, int step, double focal,
                                const Eigen::Vector2d& shift_px) {
  for (size_t v = first; v < views.size(); v += step) {
    PinholeCamera& camera = views[v].camera;
    camera.fx = camera.fy = focal;
    camera.cx += shift_px.x();
    camera.cy += shift_px.y();
  }
  for (View& view : views)
    view.calibration = std::make_shared<testing::PinholeCalibration>(view.camera);
  return views;
}

TEST(CameraRounds, OpticsComeBackFromCurves) {
  const auto views = WithOpticsOff(TrueViews(), 0, 1, 618, {1.5, -1});
  const CameraScene scene = Refine(views);
  for (size_t v = 0; v < views.size(); ++v) {
    EXPECT_NEAR(scene.views[v].camera.fx, TrueViews()[v].camera.fx, 3);
    // Up and down, a turn of all these views does the same.
    EXPECT_NEAR(scene.views[v].camera.cx, TrueViews()[v].camera.cx, 0.3);
  }
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, ErrorsOf(views).aligned_px / 4);
}

// As the check of given cameras asks: a round of poses at twice the gate, then optics.
CameraRoundsResult Check(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                         bool measures_rows = true) {
  CameraScene scene = MakeCameraScene(views, kNoHints, LooseMounts(kNumPoseViews));
  const DrawingGraph graph = CubeGraph();
  return Refine({graph, {2}, {1}, measures_rows}, curves, &scene);
}

TEST(CameraRounds, TellsWrongOpticsFromRightOnes) {
  const double focal = TrueViews()[0].camera.fx;
  EXPECT_FALSE(Check(WithOpticsOff(TrueViews(), 0, 1, focal, {0, 0}), Curves()).optics_are_off);
  EXPECT_TRUE(Check(WithOpticsOff(TrueViews(), 0, 1, 618, {1.5, -1}), Curves()).optics_are_off);
  EXPECT_TRUE(Check(WithOpticsOff(TrueViews(), 0, 1, 609, {0.8, -0.5}), Curves()).optics_are_off);
}

TEST(CameraRounds, MeasuringRowsMovesNothing) {
  const std::vector<View> views = WithOpticsOff(TrueViews(), 0, 1, 618, {1.5, -1});
  const DrawingGraph graph = CubeGraph();
  const std::vector<ImageCurves> curves = Curves();
  std::vector<std::vector<View>> refined;
  for (const bool measures_rows : {false, true}) {
    CameraScene scene = MakeCameraScene(views, kNoHints, LooseMounts(kNumPoseViews));
    Refine({graph, {1}, {1, 1}, measures_rows}, curves, &scene);
    refined.push_back(scene.views);
  }
  for (int v = 0; v < kNumPoseViews; ++v) {
    EXPECT_EQ(refined[0][v].cam_from_world.translation, refined[1][v].cam_from_world.translation);
    EXPECT_EQ(refined[0][v].camera.fx, refined[1][v].camera.fx);
  }
}

TEST(CameraRounds, OnlyViewsOfOneCameraShareItsOptics) {
  std::vector<View> views = WithOpticsOff(TrueViews(), 0, 2, 618, {0, 0});
  for (int v = 0; v < kNumPoseViews; ++v) views[v].camera_index = v % 2 == 0 ? 7 : 3;
  const std::vector<View> refined = Refine(views).views;
  for (int v = 2; v < kNumPoseViews; ++v) {
    EXPECT_EQ(refined[v].camera.fx, refined[v - 2].camera.fx);
  }
  EXPECT_NEAR(refined[0].camera.fx, refined[1].camera.fx, 1.5);
}

TEST(CameraRounds, PointsMoveToWhereTheViewsSeeThem) {
  const std::vector<ScenePoint> points = WrongPoints();
  const CameraScene scene = Refine(WrongViews(), {points});
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, 0.1);
  const SceneHints hints = HintsOf(scene, {points}, scene.views);
  ASSERT_EQ(hints.points.size(), points.size());
  for (const ScenePoint& point : hints.points) {
    for (const PointPixel& pixel : point.pixels) {
      const auto seen = scene.views[pixel.view].Project(point.position_in_world);
      ASSERT_TRUE(seen);
      EXPECT_LT((*seen - pixel.position_px).norm(), 0.3);
    }
  }
}

// Without any curve the points alone determine the cameras.
TEST(CameraRounds, PointsAloneBringCamerasBack) {
  const CameraScene scene = Refine(WrongViews(), {WrongPoints()}, 2, DrawingGraph());
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, 0.1);
}

TEST(CameraRounds, WithoutCurvesAndPointsCamerasStay) {
  const CameraScene scene = Refine(WrongViews(), kNoHints, 2, DrawingGraph());
  EXPECT_EQ(ErrorsOf(scene.views).raw_px, ErrorsOf(WrongViews()).raw_px);
}

TEST(CameraRounds, RightCamerasStay) {
  EXPECT_LT(ErrorsOf(Refine(TrueViews()).views).aligned_px, 0.1);
}

TEST(CameraRounds, HeldViewsStayAndRigsKeepTheirForm) {
  CameraScene scene = MakeCameraScene(WrongViews(), kNoHints, LooseMounts(kNumPoseViews));
  CameraMounts& mounts = scene.mounts;
  mounts.held[5] = 1;
  // View 1 rides on the body of view 0, where the true one is.
  const Rigid3d one_from_zero =
      TrueViews()[1].cam_from_world * Inverse(TrueViews()[0].cam_from_world);
  mounts.of_view[1] = {0, one_from_zero};
  scene.views[1].cam_from_world = one_from_zero * scene.views[0].cam_from_world;
  const DrawingGraph graph = CubeGraph();
  const auto result = Refine({graph, {3, 2, 1}, {1}}, Curves(), &scene);
  EXPECT_EQ(scene.views[5].cam_from_world.translation, WrongViews()[5].cam_from_world.translation);
  const Rigid3d now = scene.views[1].cam_from_world * Inverse(scene.views[0].cam_from_world);
  EXPECT_LT((now.translation - one_from_zero.translation).norm(), 1e-9);
  EXPECT_NE(scene.views[0].cam_from_world.translation, WrongViews()[0].cam_from_world.translation);
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, 0.1);
  EXPECT_EQ(result.of_view[5].certain_by_px, 0);
  EXPECT_GT(result.of_view[0].certain_by_px, 0);
  EXPECT_LT(result.of_view[0].residual_px, kNoisePx);
}

TEST(CameraRounds, TheGainTellsWrongCamerasFromRightOnes) {
  const auto gain = [](const std::vector<View>& views) {
    CameraScene scene = MakeCameraScene(views, kNoHints, LooseMounts(views.size()));
    const DrawingGraph graph = CubeGraph();
    return Refine({graph, {2}}, Curves(), &scene).gain;
  };
  EXPECT_LT(gain(TrueViews()), 0.05);
  EXPECT_GT(gain(WrongViews()), 0.3);
}

const Eigen::Affine3d kMotionOfPart =
    Eigen::Translation3d(0.02, 0, -0.01) *
    Eigen::AngleAxisd(1.2 * kDeg, Eigen::Vector3d(0.3, 0.5, 1).normalized()) * Eigen::Scaling(1.02);

bool IsInPart(int view) { return view >= 9; }

std::vector<View> ViewsWithPart() {
  const std::vector<View> moved = Moved(TrueViews(), kMotionOfPart);
  std::vector<View> views = TrueViews();
  for (int v = 0; v < kNumPoseViews; ++v) {
    if (IsInPart(v)) views[v] = moved[v];
  }
  return views;
}

// Every edge twice, as either part of the views sees it.
DrawingGraph GraphDrawnTwice() {
  DrawingGraph graph = CubeGraph();
  DrawingGraph again = CubeGraph();
  for (DrawingNode& node : again.nodes)
    node.position_in_world = kMotionOfPart * node.position_in_world;
  const auto num_nodes = static_cast<int>(graph.nodes.size());
  std::ranges::move(again.nodes, std::back_inserter(graph.nodes));
  for (DrawingLink& link : again.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point = kMotionOfPart * point;
    link.node0 += num_nodes;
    link.node1 += num_nodes;
    graph.links.push_back(std::move(link));
  }
  RebuildIncidence(&graph);
  return graph;
}

TEST(CameraRounds, APartThatIsOffMovesAsOne) {
  const DrawingGraph graph = GraphDrawnTwice();
  CameraScene scene = MakeCameraScene(ViewsWithPart(), kNoHints, LooseMounts(kNumPoseViews));
  const CameraRoundsResult result = Refine({graph, {2}, {}, false, true}, Curves(), &scene);
  ASSERT_TRUE(result.part);
  // Either part may move.
  const bool is_second = IsInPart(result.part->views.front());
  std::vector<ViewId> expected;
  for (int v = 0; v < kNumPoseViews; ++v) {
    if (IsInPart(v) == is_second) expected.push_back(v);
  }
  EXPECT_EQ(result.part->views, expected);
  const double before_px = ErrorsOf(ViewsWithPart()).aligned_px;
  EXPECT_GT(before_px, 2);
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, before_px / 10);
}

TEST(CameraRounds, NoPartOfRightCamerasIsOff) {
  const DrawingGraph graph = CubeGraph();
  CameraScene scene = MakeCameraScene(TrueViews(), kNoHints, LooseMounts(kNumPoseViews));
  EXPECT_FALSE(Refine({graph, {2}, {}, false, true}, Curves(), &scene).part);
  EXPECT_LT(ErrorsOf(scene.views).aligned_px, 0.1);
}

TEST(CameraRounds, APartIsLookedForAmongViewsThatMayMove) {
  const DrawingGraph graph = GraphDrawnTwice();
  const CameraScene given = MakeCameraScene(ViewsWithPart(), kNoHints, LooseMounts(kNumPoseViews));
  for (const int first_free : {9, 12}) {
    CameraScene scene = given;
    for (int v = 0; v < first_free; ++v) scene.mounts.held[v] = 1;
    const CameraRoundsResult result = Refine({graph, {2}, {}, false, true}, Curves(), &scene);
    EXPECT_EQ(result.part ? result.part->views.size() : 0,
              first_free == 9 ? 7 : 0);  // 4 are too few
    for (int v = 0; v < first_free; ++v) {
      EXPECT_EQ(scene.views[v].cam_from_world.translation,
                given.views[v].cam_from_world.translation);
    }
  }
}

std::vector<ViewId> PartOfViews() {
  std::vector<ViewId> views;
  for (int v = 0; v < kNumPoseViews; ++v) {
    if (IsInPart(v)) views.push_back(v);
  }
  return views;
}

TEST(CameraRounds, AViewThatWasLeftBehindFollowsItsPart) {
  constexpr int kLeft = 12;
  std::vector<View> views = TrueViews();
  views[kLeft] = ViewsWithPart()[kLeft];
  MovedPart part = {PartOfViews(), kMotionOfPart.inverse()};
  std::erase(part.views, kLeft);
  CameraScene scene = MakeCameraScene(views, kNoHints, LooseMounts(kNumPoseViews));
  const DrawingGraph graph = CubeGraph();
  const auto result = Refine({graph, {1}, {}, false, true, part}, Curves(), &scene);
  ASSERT_TRUE(result.part);
  EXPECT_EQ(result.part->views, PartOfViews());
  EXPECT_LT(ErrorsOf(scene.views).raw_px, 0.01);
}

TEST(CameraRounds, APartThatIsStillOffIsTold) {
  const auto left = [](const std::vector<View>& views, const DrawingGraph& graph) {
    const MovedPart nowhere = {PartOfViews()};
    CameraScene scene = MakeCameraScene(views, kNoHints, LooseMounts(kNumPoseViews));
    return Refine({graph, {1}, {}, false, false, nowhere}, Curves(), &scene).part_left;
  };
  EXPECT_FALSE(left(ViewsWithPart(), GraphDrawnTwice()).empty());
  EXPECT_TRUE(left(TrueViews(), CubeGraph()).empty());
}

// Errors of cameras in terms of what is said of them, for edgels with other noise each time.
TEST(CameraRounds, CertaintyIsRight) {
  const DrawingGraph graph = CubeGraph();
  double squares = 0;
  int count = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::vector<ImageCurves> curves;
    for (const View& view : TrueViews()) {
      curves.push_back(testing::ProjectCurves(view, CubeEdges(), kNoisePx,
                                              100 * seed + static_cast<unsigned>(curves.size())));
    }
    CameraScene scene = MakeCameraScene(TrueViews(), kNoHints, LooseMounts(kNumPoseViews));
    const auto result = Refine({graph, {1}, {1}}, curves, &scene);
    const Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const Gauge gauge = FindGauge(TrueViews(), scene.views, middle);
    const std::vector<View> aligned = Moved(scene.views, gauge.given_from_refined);
    for (int v = 0; v < kNumPoseViews; ++v) {
      const Eigen::Vector2d error_px =
          *aligned[v].Project(middle) - *TrueViews()[v].Project(middle);
      const double sigma_px = result.of_view[v].certain_by_px;
      squares += error_px.squaredNorm() / (2 * sigma_px * sigma_px);
      ++count;
    }
  }
  // There are fewer curves than unknowns.
  EXPECT_GT(squares / count, 0.1);
  EXPECT_LT(squares / count, 3);
}

// Sheared images, as of cameras that turn while they expose one row after the other.
TEST(CameraRounds, RowsThatAreOutOfStepAreSeen) {
  std::vector<ImageCurves> curves = Curves();
  const auto rows_of = [&] {
    CameraScene scene = MakeCameraScene(TrueViews(), kNoHints, LooseMounts(kNumPoseViews));
    const DrawingGraph graph = CubeGraph();
    return Refine({graph, {2, 1}, {1}, true}, curves, &scene).rows;
  };
  const RowMotion straight = rows_of();
  ASSERT_EQ(straight.of_view.size(), kNumPoseViews);
  EXPECT_GT(straight.of_view[0].sigma_px, 0);
  EXPECT_FALSE(straight.IsRollingShutter());
  for (int v = 0; v < kNumPoseViews; ++v) {
    for (Edgel& edgel : curves[v].edge_map.edgels) {
      const double row = edgel.position_px.y() / TrueViews()[v].camera.height - 0.5;
      edgel.position_px.x() += (v % 2 == 0 ? 3 : -3) * row;
      edgel.stored_px = edgel.position_px.cast<float>();
    }
  }
  for (const RowMotion& sheared : {rows_of(), Check(TrueViews(), curves).rows}) {
    EXPECT_TRUE(sheared.IsRollingShutter());
    EXPECT_NEAR(sheared.skew_px, 3, 1);
  }
}

TEST(CameraRounds, ResultDoesNotDependOnThreads) {
  const CameraScene one = Refine(WrongViews(), kNoHints, 1);
  const CameraScene two = Refine(WrongViews(), kNoHints, 2);
  for (int v = 0; v < kNumPoseViews; ++v) {
    EXPECT_EQ(one.views[v].cam_from_world.translation, two.views[v].cam_from_world.translation);
  }
}

TEST(CameraRounds, CanBeCancelled) {
  std::atomic<bool> cancelled = true;
  RunContext context;
  context.cancelled = &cancelled;
  CameraScene scene = MakeCameraScene(WrongViews(), kNoHints, LooseMounts(kNumPoseViews));
  const DrawingGraph graph = CubeGraph();
  EXPECT_THROW(Refine({graph, {1}}, Curves(), &scene, context), Cancelled);
}

}  // namespace
}  // namespace limn
