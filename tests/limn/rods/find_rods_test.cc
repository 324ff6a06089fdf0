// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/find_rods.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/rods/rod_sights.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/graph_fixture.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kDistance = 5;
constexpr double kPx = kDistance / 600;

// Views from a part of a circle around the z axis, up to this far above or below it.
std::vector<View> Views(double half_range_deg = 80, double height = 2) {
  std::vector<View> views;
  for (int i = -6; i <= 6; ++i) {
    views.push_back(testing::RingView(half_range_deg * i / 6, kDistance, (i % 3) * height));
  }
  return views;
}

Polyline3d Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Polyline3d line;
  for (int k = 0; k <= 100; ++k) line.push_back(from + (to - from) * k / 100.0);
  return line;
}

const Polyline3d kUpright = Line({0, 0, -0.6}, {0, 0, 0.6});

Eigen::Vector3d TangentOf(const Polyline3d& line, size_t k) {
  const size_t next = std::min(k + 1, line.size() - 1);
  const size_t before = k == 0 ? 0 : k - 1;
  return (line[next] - line[before]).normalized();
}

// The outlines of a body of this radius around a line as one view sees them: where lines of sight
// touch it, blurred. Both run so that the outside is brighter.
std::vector<testing::SceneCurve> Outlines(const View& view, const Polyline3d& axis,
                                          double radius_px) {
  std::vector<testing::SceneCurve> outlines(2);
  for (size_t k = 0; k < axis.size(); ++k) {
    const Eigen::Vector3d tangent = TangentOf(axis, k);
    Eigen::Vector3d toward = view.CenterInWorld() - axis[k];
    toward -= tangent.dot(toward) * tangent;
    const double footprint = *FootprintIn(view, axis[k]);
    const double radius = SeenHalfWidth(radius_px * kPx / footprint) * footprint;
    const double sine = radius / toward.norm();
    const Eigen::Vector3d across = toward.normalized().cross(tangent);
    for (const int side : {0, 1}) {
      outlines[side].points.push_back(
          axis[k] + radius * (sine * toward.normalized() +
                              (side == 0 ? 1 : -1) * std::sqrt(1 - sine * sine) * across));
    }
  }
  std::ranges::reverse(outlines[1].points);
  return outlines;
}

// What the views show, and what is drawn of it.
struct RodScene {
  std::vector<View> views = Views();
  std::vector<std::vector<testing::SceneCurve>> shown;  // per view
  DrawingGraph graph;

  explicit RodScene(std::vector<View> of_views = Views())
      : views(std::move(of_views)), shown(views.size()) {}

  void ShowRod(const Polyline3d& axis, double radius_px) {
    for (size_t v = 0; v < views.size(); ++v) {
      for (testing::SceneCurve& curve : Outlines(views[v], axis, radius_px)) {
        shown[v].push_back(std::move(curve));
      }
    }
  }
  void Show(const Polyline3d& line) {
    for (auto& of_view : shown) of_view.push_back({line, false});
  }
  void Draw(const Polyline3d& line) {
    DrawingLink link;
    link.points_in_world = line;
    link.sigma.assign(line.size(), 0.1 * kPx);
    for (ViewId v = 0; v < std::ssize(views); ++v) link.supporting_views.push_back(v);
    GraphEditor(&graph).Add(std::move(link));
  }
  // The outlines as the view in the middle sees them, between two points of the axis.
  void DrawOutlines(const Polyline3d& axis, double radius_px, size_t begin, size_t end) {
    const Polyline3d part(axis.begin() + static_cast<std::ptrdiff_t>(begin),
                          axis.begin() + static_cast<std::ptrdiff_t>(end));
    for (const auto& curve : Outlines(views[views.size() / 2], part, radius_px)) {
      Draw(curve.points);
    }
  }

  RodResult Find(int num_threads = 1) const {
    std::vector<ImageCurves> curves;
    for (size_t v = 0; v < views.size(); ++v) {
      curves.push_back(testing::ProjectCurves(views[v], shown[v], 0.1, static_cast<unsigned>(v)));
    }
    RunContext context;
    context.num_threads = num_threads;
    RodResult result = FindRods({{views, curves}, graph}, context);
    testing::ExpectValid(result.graph);
    return result;
  }
};

std::vector<DrawingLink> RodsOf(const DrawingGraph& graph) {
  std::vector<DrawingLink> rods;
  for (const DrawingLink& link : graph.links) {
    if (link.kind == LinkKind::kRod) rods.push_back(link);
  }
  return rods;
}

std::vector<LinkDoubt> DoubtsOfOthers(const DrawingGraph& graph) {
  std::vector<LinkDoubt> doubts;
  for (const DrawingLink& link : graph.links) {
    EXPECT_EQ(link.tentative, link.doubt != LinkDoubt::kNone);
    if (link.kind != LinkKind::kRod) doubts.push_back(link.doubt);
  }
  return doubts;
}

constexpr LinkDoubt kNone = LinkDoubt::kNone;
constexpr LinkDoubt kOutline = LinkDoubt::kRodOutline;

void ExpectAlong(const DrawingLink& rod, const Polyline3d& axis, double radius_px) {
  EXPECT_NEAR(rod.rod_radius, radius_px * kPx, 0.1 * kPx);
  EXPECT_NEAR(Length(rod.points_in_world), Length(axis), 5 * kPx);
  const Polyline3d& points = rod.points_in_world;
  for (size_t k = 0; k < points.size(); ++k) {
    const bool is_end = k == 0 || k + 1 == points.size();
    EXPECT_LT(std::sqrt(ClosestPoint(axis, points[k]).squared_distance),
              (is_end ? 2.5 : 0.25) * kPx);
  }
}

class RadiusTest : public ::testing::TestWithParam<double> {};

TEST_P(RadiusTest, TwoOutlinesBecomeARod) {
  RodScene scene;
  scene.ShowRod(kUpright, GetParam());
  scene.DrawOutlines(kUpright, GetParam(), 0, 101);
  const RodResult result = scene.Find();
  const std::vector<DrawingLink> rods = RodsOf(result.graph);
  ASSERT_EQ(rods.size(), 1u);
  ExpectAlong(rods[0], kUpright, GetParam());
  EXPECT_EQ(rods[0].supporting_views.size(), scene.views.size());
  EXPECT_EQ(DoubtsOfOthers(result.graph), (std::vector{kOutline, kOutline}));
}

INSTANTIATE_TEST_SUITE_P(Thicknesses, RadiusTest, ::testing::Values(1.5, 2.0, 3.0));

TEST(FindRodsTest, TheEdgesOfAStripAreNoRod) {
  RodScene scene;
  const Eigen::Vector3d aside(0, 2 * kPx, 0);
  Polyline3d left = Line(Eigen::Vector3d(0, 0, -0.6) - aside, Eigen::Vector3d(0, 0, 0.6) - aside);
  Polyline3d right = Line(Eigen::Vector3d(0, 0, 0.6) + aside, Eigen::Vector3d(0, 0, -0.6) + aside);
  for (const Polyline3d& edge : {left, right}) {
    scene.Show(edge);
    scene.Draw(edge);
  }
  EXPECT_EQ(DoubtsOfOthers(scene.Find().graph), (std::vector{kNone, kNone}));
}

// Neither is what looks like one from the front only.
TEST(FindRodsTest, ViewsFromOneSideDoNotTellARodFromAStrip) {
  RodScene scene(Views(12, 0.3));
  scene.ShowRod(kUpright, 1.5);
  scene.DrawOutlines(kUpright, 1.5, 0, 101);
  EXPECT_EQ(DoubtsOfOthers(scene.Find().graph), (std::vector{kNone, kNone}));
}

TEST(FindRodsTest, ABentRodGrowsFromAPartOfItsOutlines) {
  Polyline3d bent;
  for (int k = 0; k <= 100; ++k) {
    const double angle = M_PI * k / 100;
    bent.emplace_back(0.1 * std::sin(angle), 0.5 * std::cos(angle), 0.5 * std::sin(angle) - 0.3);
  }
  RodScene scene;
  scene.ShowRod(bent, 1.5);
  scene.DrawOutlines(bent, 1.5, 30, 60);
  const std::vector<DrawingLink> rods = RodsOf(scene.Find().graph);
  ASSERT_EQ(rods.size(), 1u);
  ExpectAlong(rods[0], bent, 1.5);
}

TEST(FindRodsTest, ALinkIsCutWhereItLeavesARod) {
  RodScene scene;
  scene.ShowRod(kUpright, 1.5);
  scene.DrawOutlines(kUpright, 1.5, 0, 101);
  Polyline3d leaves = Line({0, -1.5 * kPx, -0.5}, {0, -1.5 * kPx, 0});
  const Polyline3d away = Line({0, -1.5 * kPx, 0}, {0, -0.6, 0.1});
  leaves.insert(leaves.end(), away.begin() + 1, away.end());
  scene.Draw(leaves);
  const DrawingGraph graph = scene.Find().graph;
  EXPECT_EQ(DoubtsOfOthers(graph), (std::vector{kOutline, kOutline, kOutline, kNone}));
  EXPECT_NEAR(Length(graph.links[2].points_in_world), 0.5, 6 * kPx);
}

TEST(FindRodsTest, NothingIsFoundInNothing) {
  EXPECT_TRUE(RodScene().Find().graph.links.empty());
  EXPECT_TRUE(RodScene(std::vector<View>()).Find().graph.links.empty());
  RodScene unseen;
  unseen.DrawOutlines(kUpright, 1.5, 0, 101);
  EXPECT_EQ(DoubtsOfOthers(unseen.Find().graph), (std::vector{kNone, kNone}));
}

TEST(FindRodsTest, EndsThatTouchAreOneNode) {
  const Polyline3d level = Line({0, 0.02, 0.6}, {0, 0.9, 0.6});
  RodScene scene;
  for (const Polyline3d& axis : {kUpright, level}) {
    scene.ShowRod(axis, 1.5);
    scene.DrawOutlines(axis, 1.5, 0, 101);
  }
  const std::vector<DrawingLink> rods = RodsOf(scene.Find().graph);
  ASSERT_EQ(rods.size(), 2u);
  const std::set<NodeId> nodes = {rods[0].node0, rods[0].node1, rods[1].node0, rods[1].node1};
  EXPECT_EQ(nodes.size(), 3u);
}

TEST(FindRodsTest, RodsAreFoundAnewWithAnyNumberOfThreads) {
  RodScene scene;
  scene.ShowRod(kUpright, 1.5);
  scene.DrawOutlines(kUpright, 1.5, 0, 101);
  scene.Show(Line({0, -0.4, -0.3}, {0, -0.4, 0.3}));
  scene.Draw(Line({0, -0.4, -0.3}, {0, -0.4, 0.3}));
  const RodResult once = scene.Find();
  const DrawingGraph without = WithoutRods(once.graph);
  EXPECT_EQ(without.links.size(), scene.graph.links.size());
  EXPECT_EQ(DoubtsOfOthers(without), (std::vector{kNone, kNone, kNone}));
  scene.graph = once.graph;
  const RodResult again = scene.Find(3);
  ASSERT_EQ(again.graph.links.size(), once.graph.links.size());
  for (size_t l = 0; l < once.graph.links.size(); ++l) {
    EXPECT_EQ(again.graph.links[l].points_in_world, once.graph.links[l].points_in_world);
    EXPECT_EQ(again.graph.links[l].doubt, once.graph.links[l].doubt);
  }
}

}  // namespace
}  // namespace limn
