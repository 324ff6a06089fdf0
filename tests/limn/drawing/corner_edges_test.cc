#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "limn/drawing/drawing.h"
#include "limn/drawing/joints.h"
#include "limn/sketch/sketch.h"
#include "limn/support/segment_evidence.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSide = 0.2;  // edges of about 48 px

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(16, 5);
  return views;
}

Eigen::Vector3d Middle(const testing::SceneCurve& curve) {
  return 0.5 * (curve.points.front() + curve.points.back());
}

// The enhanced sketch of a wire cube, without what was reconstructed of its first edge.
CurveSketch SketchWithoutFirstEdge(const std::vector<ImageCurves>& curves) {
  const SceneHints no_hints;
  CurveSketch sketch =
      BuildEnhancedSketch({Views(), curves, no_hints, std::nullopt}, SketchOptions(), {}).sketch;
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSide).front());
  std::erase_if(sketch.curves, [&](const Curve3D& curve) {
    const Eigen::Vector3d middle =
        0.5 * (curve.points_in_world.front() + curve.points_in_world.back());
    return (middle - missing).norm() < 0.3 * kHalfSide;
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

TEST(CornerEdgesTest, EdgeThatTheSketchLostGrowsFromItsCorner) {
  const auto curves = testing::ProjectCurves(Views(), testing::CubeEdges(kHalfSide), 0.2);
  const DrawingResult result =
      BuildDrawing({Views(), curves, SketchWithoutFirstEdge(curves)}, DrawingOptions(), {});
  const DrawingGraph& graph = result.graph;
  EXPECT_TRUE(Validate(graph).empty());
  EXPECT_EQ(NumSamplesAccountedFor(result.summary), CountOf(result.summary.in, "samples"));
  EXPECT_EQ(graph.links.size(), 12u);
  EXPECT_EQ(NumNodesOfDegree(graph, 3), 8);
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSide).front());
  const double footprint = 5.0 / 600;
  const bool found =
      std::any_of(graph.links.begin(), graph.links.end(), [&](const DrawingLink& link) {
        return std::sqrt(ClosestPoint(link.points_in_world, missing).squared_distance) <
                   0.5 * footprint &&
               link.supporting_views.size() >= 4;
      });
  EXPECT_TRUE(found);
}

TEST(CornerEdgesTest, NothingGrowsOutOfTheBox) {
  const auto curves = testing::ProjectCurves(Views(), testing::CubeEdges(kHalfSide), 0.2);
  const CurveSketch sketch = SketchWithoutFirstEdge(curves);
  // All corners but those of the missing edge are inside, which it leaves at once.
  Eigen::AlignedBox3d box;
  for (const testing::SceneCurve& edge : testing::CubeEdges(0.9 * kHalfSide)) {
    box.extend(edge.points.front());
  }
  const DrawingGraph graph =
      BuildDrawing({Views(), curves, sketch, box}, DrawingOptions(), {}).graph;
  EXPECT_TRUE(Validate(graph).empty());
  const Eigen::Vector3d missing = Middle(testing::CubeEdges(kHalfSide).front());
  EXPECT_TRUE(std::none_of(graph.links.begin(), graph.links.end(), [&](const DrawingLink& link) {
    return std::sqrt(ClosestPoint(link.points_in_world, missing).squared_distance) <
           0.1 * kHalfSide;
  }));
}

TEST(CornerEdgesTest, NothingGrowsWhereImagesShowNothing) {
  auto edges = testing::CubeEdges(kHalfSide);
  edges.erase(edges.begin());
  const auto curves = testing::ProjectCurves(Views(), edges, 0.2);
  const DrawingGraph graph =
      BuildDrawing({Views(), curves, SketchWithoutFirstEdge(curves)}, DrawingOptions(), {}).graph;
  EXPECT_TRUE(Validate(graph).empty());
  EXPECT_EQ(graph.links.size(), 11u);
  EXPECT_EQ(NumNodesOfDegree(graph, 3), 6);
  EXPECT_EQ(NumNodesOfDegree(graph, 2), 2);
}

TEST(SegmentEvidenceTest, SeesTrueEdgesAndNoOthers) {
  const auto edges = testing::CubeEdges(kHalfSide);
  const auto curves = testing::ProjectCurves(Views(), edges);
  const SupportGate gate{1.5, 1.5, 0.4};
  const auto views = BuildEvidence(curves, {});
  const EdgelEvidence evidence = IndexEdgels(curves, views, SampleSet(), Draft());
  const Eigen::Vector3d from = edges.front().points.front();
  const Eigen::Vector3d to = edges.front().points.back();
  const std::vector<uint8_t> all(Views().size(), 1);
  const SegmentEvidence seen = FindEvidence(from, to, all, Views(), evidence.all, gate);
  EXPECT_EQ(seen.num_views, 16);
  EXPECT_EQ(seen.seen_in.size(), 16u);
  EXPECT_LT(seen.background, 0.2);
  // A diagonal through the empty cube.
  const SegmentEvidence unseen = FindEvidence(from, -from, all, Views(), evidence.all, gate);
  EXPECT_LE(unseen.seen_in.size(), 1u);
}

// P(at least k of n) for independent trials.
double BinomialTail(int k, int n, double p) {
  double sum = 0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) +
                    i * std::log(p) + (n - i) * std::log(1 - p));
  }
  return sum;
}

TEST(SegmentEvidenceTest, LogChanceBoundsTheBinomialTail) {
  const int n = kIndependentViews;
  for (const int num_views : {n, 20}) {
    for (const double p : {0.02, 0.1, 0.3}) {
      for (int k = 1; k <= num_views; ++k) {
        EXPECT_GE(LogChance(k, num_views, p), std::log(BinomialTail(k, num_views, p)) - 1e-9)
            << k << " " << p;
        EXPECT_LE(LogChance(k, num_views, p), LogChance(k - 1, num_views, p));
      }
    }
  }
  EXPECT_EQ(LogChance(2, 20, 0.1), 0);
  EXPECT_NEAR(LogChance(n, n, 0.1), n * std::log(0.1), 1e-9);
  EXPECT_EQ(LogChance(0, 0, 0.1), 0);
  // More views say no more, at the same share.
  EXPECT_EQ(LogChance(n / 2, n, 0.1), LogChance(5 * n, 10 * n, 0.1));
}

}  // namespace
}  // namespace limn
