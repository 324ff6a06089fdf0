// SPDX-License-Identifier: BSD-3-Clause
// Edges that the sketch lost are in the drawing.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "limn/drawing/drawing.h"
#include "limn/geometry/polyline.h"
#include "limn/sketch/sketch.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSideOfCube = 0.2;  // edges of about 48 px

const std::vector<View>& ViewsOfLostEdges() {
  static const std::vector<View> views = testing::DomeViews(16, 5);
  return views;
}

Eigen::Vector3d Middle(const testing::SceneCurve& curve) {
  return 0.5 * (curve.points.front() + curve.points.back());
}

// The sketch of a wire cube, without what was reconstructed of its first edge.
CurveSketch SketchWithoutFirstEdge(const std::vector<ImageCurves>& curves) {
  CurveSketch sketch = BuildSweptSketch({{ViewsOfLostEdges(), curves}}, SketchOptions(), {}).sketch;
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSideOfCube).front());
  std::erase_if(sketch.curves, [&](const Curve3D& curve) {
    const Eigen::Vector3d middle =
        0.5 * (curve.points_in_world.front() + curve.points_in_world.back());
    return (middle - missing).norm() < 0.3 * kHalfSideOfCube;
  });
  return sketch;
}

int NumNodesOfDegree(const DrawingGraph& graph, int degree) {
  return static_cast<int>(
      std::count_if(graph.nodes.begin(), graph.nodes.end(),
                    [&](const DrawingNode& node) { return node.Degree() == degree; }));
}

int64_t CountOf(const StageSummary::Counts& counts, const std::string& name) {
  for (const auto& [unit, count] : counts) {
    if (unit == name) return count;
  }
  return -1;
}

int64_t NumSamplesAccountedFor(const StageSummary& summary) {
  int64_t sum = CountOf(summary.kept, "samples");
  for (const auto& [reason, count] : summary.dropped) {
    if (reason.rfind("samples:", 0) == 0) sum += count;
  }
  return sum;
}

TEST(LostEdgesTest, EdgeThatTheSketchLostGrowsFromItsCorner) {
  const auto curves =
      testing::ProjectCurves(ViewsOfLostEdges(), testing::CubeEdges(kHalfSideOfCube), 0.2);
  const DrawingResult result = BuildDrawing(
      {{ViewsOfLostEdges(), curves}, SketchWithoutFirstEdge(curves)}, DrawingOptions(), {});
  const DrawingGraph& graph = result.graph;
  EXPECT_TRUE(Validate(graph).empty());
  EXPECT_EQ(NumSamplesAccountedFor(result.summary), CountOf(result.summary.in, "samples"));
  EXPECT_EQ(graph.links.size(), 12u);
  EXPECT_EQ(NumNodesOfDegree(graph, 3), 8);
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSideOfCube).front());
  const double footprint = 5.0 / 600;
  const bool found =
      std::any_of(graph.links.begin(), graph.links.end(), [&](const DrawingLink& link) {
        return std::sqrt(ClosestPoint(link.points_in_world, missing).squared_distance) <
                   0.5 * footprint &&
               link.supporting_views.size() >= 4;
      });
  EXPECT_TRUE(found);
}

TEST(LostEdgesTest, NothingGrowsOutOfTheBox) {
  const auto curves =
      testing::ProjectCurves(ViewsOfLostEdges(), testing::CubeEdges(kHalfSideOfCube), 0.2);
  const CurveSketch sketch = SketchWithoutFirstEdge(curves);
  // All corners but those of the missing edge are inside, which it leaves at once.
  Eigen::AlignedBox3d box;
  for (const testing::SceneCurve& edge : testing::CubeEdges(0.9 * kHalfSideOfCube)) {
    box.extend(edge.points.front());
  }
  const DrawingGraph graph =
      BuildDrawing({{ViewsOfLostEdges(), curves, kNoHints, box}, sketch}, DrawingOptions(), {})
          .graph;
  EXPECT_TRUE(Validate(graph).empty());
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSideOfCube).front());
  EXPECT_TRUE(std::none_of(graph.links.begin(), graph.links.end(), [&](const DrawingLink& link) {
    return std::sqrt(ClosestPoint(link.points_in_world, missing).squared_distance) <
           0.1 * kHalfSideOfCube;
  }));
}

TEST(LostEdgesTest, NothingGrowsWhereImagesShowNothing) {
  auto edges = testing::CubeEdges(kHalfSideOfCube);
  edges.erase(edges.begin());
  const auto curves = testing::ProjectCurves(ViewsOfLostEdges(), edges, 0.2);
  const DrawingGraph graph =
      BuildDrawing({{ViewsOfLostEdges(), curves}, SketchWithoutFirstEdge(curves)}, DrawingOptions(),
                   {})
          .graph;
  EXPECT_TRUE(Validate(graph).empty());
  EXPECT_EQ(graph.links.size(), 11u);
  EXPECT_EQ(NumNodesOfDegree(graph, 3), 6);
  EXPECT_EQ(NumNodesOfDegree(graph, 2), 2);
}

}  // namespace
}  // namespace limn
