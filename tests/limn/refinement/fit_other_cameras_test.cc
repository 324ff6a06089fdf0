// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/fit_other_cameras.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::IsEmpty;

constexpr int kNumOwnViews = 16;
constexpr double kRingRadius = 0.7;

const std::vector<View>& OwnViews() {
  static const std::vector<View> views = testing::DomeViews(kNumOwnViews, 5);
  return views;
}

double OwnPx() { return *FootprintIn(OwnViews()[0], Eigen::Vector3d::Zero()); }

testing::SceneCurve Wire() { return testing::Segment({-0.8, -0.5, 0.3}, {0.7, 0.6, -0.2}); }
testing::SceneCurve Ring() { return testing::Circle(Eigen::Vector3d::Zero(), kRingRadius); }

// A wire and a ring.
const std::vector<ImageCurves>& OwnCurves() {
  static const auto curves = testing::ProjectCurves(OwnViews(), {Wire(), Ring()});
  return curves;
}

void AddPaint(const Polyline3d& points, DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world = points;
  link.sigma.assign(points.size(), OwnPx());
  link.closed = points.front() == points.back();
  link.node0 = static_cast<NodeId>(graph->nodes.size());
  link.node1 = link.closed ? link.node0 : link.node0 + 1;
  graph->nodes.resize(link.node1 + 1);
  graph->nodes[link.node0].position_in_world = points.front();
  graph->nodes[link.node1].position_in_world = points.back();
  for (ViewId v = 0; v < kNumOwnViews; ++v) link.supporting_views.push_back(v);
  link.kind = LinkKind::kPaint;
  graph->links.push_back(std::move(link));
}

DrawingGraph DrawnPaint() {
  DrawingGraph graph;
  for (const Polyline3d& points : testing::Polylines({Wire(), Ring()})) AddPaint(points, &graph);
  RebuildIncidence(&graph);
  return graph;
}

OtherCamerasResult FitOthers(const DrawingGraph& graph, const std::vector<View>& others,
                             const std::vector<ImageCurves>& curves = OwnCurves()) {
  OtherCamerasResult result =
      FitOtherCameras({{{OwnViews(), OwnCurves()}, graph}, {others, curves}}, {}, {});
  EXPECT_THAT(Validate(result.graph), IsEmpty());
  return result;
}

// Largest distance of the points of a link from a curve.
double FarthestPx(const DrawingLink& link, const Polyline3d& curve) {
  double farthest = 0;
  for (const Eigen::Vector3d& point : link.points_in_world) {
    farthest = std::max(farthest, ClosestPoint(curve, point).squared_distance);
  }
  return std::sqrt(farthest) / OwnPx();
}

Rigid3d Turn(double rad) {
  Rigid3d turn;
  turn.rotation = Eigen::AngleAxisd(rad, Eigen::Vector3d(1, 2, 1).normalized());
  return turn;
}

// The cameras, in a world that has moved.
std::vector<View> MovedViews(const Rigid3d& motion) {
  std::vector<View> views = OwnViews();
  for (View& view : views) view.cam_from_world = view.cam_from_world * Inverse(motion);
  return views;
}

// Turned about their centers by this many pixels, each second one back.
std::vector<View> TurnedViews(double px) {
  std::vector<View> views = OwnViews();
  for (size_t v = 0; v < views.size(); ++v) {
    const double rad = (v % 2 == 0 ? px : -px) / views[v].camera.MeanFocal();
    views[v].cam_from_world = Turn(rad) * views[v].cam_from_world;
  }
  return views;
}

TEST(FitOtherCameras, CurvesGoWithCamerasThatMoveTogether) {
  Rigid3d motion = Turn(0.01);
  motion.translation = Eigen::Vector3d(4, -3, 2) * OwnPx();
  const DrawingGraph graph = DrawnPaint();
  const OtherCamerasResult result = FitOthers(graph, MovedViews(motion));
  EXPECT_GT(result.before_px, 2);
  EXPECT_LT(result.after_px, 0.05);
  // Free ends do not move along their curve.
  const Eigen::Vector3d from = graph.links[0].points_in_world.front();
  const Eigen::Vector3d to = graph.links[0].points_in_world.back();
  const Polyline3d whole_lines[2] = {{from - (to - from), to + (to - from)},
                                     graph.links[1].points_in_world};
  for (int l = 0; l < 2; ++l) {
    Polyline3d moved = whole_lines[l];
    for (Eigen::Vector3d& point : moved) point = motion * point;
    EXPECT_LT(FarthestPx(result.graph.links[l], moved), 0.2) << l;
    EXPECT_LT(result.graph.links[l].residual_px, 0.1) << l;
  }
}

TEST(FitOtherCameras, SameCamerasChangeNothing) {
  const DrawingGraph graph = DrawnPaint();
  const OtherCamerasResult result = FitOthers(graph, OwnViews());
  EXPECT_LT(result.before_px, 0.05);
  for (int l = 0; l < 2; ++l) {
    EXPECT_LT(FarthestPx(result.graph.links[l], graph.links[l].points_in_world), 0.05) << l;
  }
}

// Optics change where edgels are in the virtual image, and the curves stay.
TEST(FitOtherCameras, EdgelsAreThoseOfTheOtherLens) {
  std::vector<View> others = OwnViews();
  std::vector<ImageCurves> curves = OwnCurves();
  constexpr double kZoom = 1.2;
  for (int v = 0; v < kNumOwnViews; ++v) {
    PinholeCamera& camera = others[v].camera;
    camera.fx *= kZoom;
    camera.fy *= kZoom;
    const Eigen::Vector2d center(camera.cx, camera.cy);
    for (Edgel& edgel : curves[v].edge_map.edgels) {
      edgel.position_px = center + kZoom * (edgel.position_px - center);
      edgel.stored_from_virtual /= kZoom;
    }
  }
  const DrawingGraph graph = DrawnPaint();
  const OtherCamerasResult result = FitOthers(graph, others, curves);
  EXPECT_LT(result.before_px, 0.05);
  for (int l = 0; l < 2; ++l) {
    EXPECT_LT(FarthestPx(result.graph.links[l], graph.links[l].points_in_world), 0.05) << l;
  }
}

TEST(FitOtherCameras, CamerasThatDisagreeLeaveResidualsAndUnsureCurves) {
  const DrawingGraph graph = DrawnPaint();
  const double sure = FitOthers(graph, OwnViews()).graph.links[0].sigma[10];
  const OtherCamerasResult result = FitOthers(graph, TurnedViews(3));
  EXPECT_LT(result.after_px, result.before_px + 1e-3);
  EXPECT_GT(result.after_px, 0.5);
  EXPECT_GT(result.graph.links[0].sigma[10], 3 * sure);
  EXPECT_GT(result.graph.links[0].residual_px, 0.5);
}

TEST(FitOtherCameras, AllElseStays) {
  DrawingGraph graph = DrawnPaint();
  graph.links[1].supporting_views = {0, 1, 2, 3, 4, 5, 6};
  graph.links[1].tentative = true;
  graph.links[1].doubt = LinkDoubt::kChance;
  graph.links[0].primitive = LinkPrimitive();
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].body = {RoundShape::kSphere, {0, 0, 0}, {0, 0, 0}, 1, 1, 0, 0};
  const DrawingGraph moved = FitOthers(graph, TurnedViews(3)).graph;
  ASSERT_EQ(moved.links.size(), 2u);
  for (int l = 0; l < 2; ++l) {
    EXPECT_EQ(moved.links[l].supporting_views, graph.links[l].supporting_views) << l;
    EXPECT_EQ(moved.links[l].kind, graph.links[l].kind) << l;
    EXPECT_FALSE(moved.links[l].body) << l;
    EXPECT_EQ(moved.links[l].doubt, graph.links[l].doubt) << l;
    EXPECT_FALSE(moved.links[l].primitive) << l;
  }
}

// Nothing else than edgels moves curves: not those that a lens cannot map.
TEST(FitOtherCameras, LinksWithoutEdgelsStay) {
  std::vector<ImageCurves> curves = OwnCurves();
  for (ImageCurves& of_view : curves) of_view.fragments.erase(of_view.fragments.begin());
  DrawingGraph graph = DrawnPaint();
  AddPaint(ResampleUniform(Polyline3d{{-0.5, 0.9, 0.5}, {0.5, 0.9, 0.5}}, OwnPx()), &graph);
  RebuildIncidence(&graph);
  Rigid3d motion;
  motion.translation = Eigen::Vector3d(3, 0, 0) * OwnPx();
  const OtherCamerasResult result = FitOthers(graph, MovedViews(motion), curves);
  EXPECT_LT(FarthestPx(result.graph.links[0], graph.links[0].points_in_world), 0.05);
  EXPECT_EQ(result.graph.links[2].points_in_world, graph.links[2].points_in_world);
  EXPECT_GE(result.graph.links[2].sigma[0], 0.9 * OwnPx());
  EXPECT_EQ(result.summary.kept.back().second, 2);
}

TEST(FitOtherCameras, ChecksOptions) {
  RefinementOptions options;
  options.max_distance_px = -1;
  const DrawingGraph graph = DrawnPaint();
  EXPECT_THROW(
      FitOtherCameras({{{OwnViews(), OwnCurves()}, graph}, {OwnViews(), OwnCurves()}}, options, {}),
      OptionError);
}

}  // namespace
}  // namespace limn
