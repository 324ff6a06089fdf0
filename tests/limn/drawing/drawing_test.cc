// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/drawing.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "limn/model/footprint.h"
#include "limn/sketch/sketch.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSide = 0.8;
constexpr int kNumCubeViews = 16;

// A wire cube with a circle on its top face: 13 curves, 8 corners.
std::vector<testing::SceneCurve> CubeWithCircle() {
  std::vector<testing::SceneCurve> curves = testing::CubeEdges(kHalfSide);
  curves.push_back(testing::Circle({0, 0, kHalfSide}, 0.45));
  return curves;
}

RunContext Threads(int num_threads) {
  RunContext context;
  context.num_threads = num_threads;
  return context;
}

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(kNumCubeViews, 5);
  return views;
}

// What drawings are made from.
struct Sketched {
  std::vector<View> views;
  std::vector<ImageCurves> curves;
  CurveSketch sketch;
};

Sketched Sketch(const std::vector<View>& views, double noise_px) {
  Sketched sketched = {views, testing::ProjectCurves(Views(), CubeWithCircle(), noise_px), {}};
  sketched.sketch =
      BuildSweptSketch({{views, sketched.curves}}, SketchOptions(), Threads(2)).sketch;
  return sketched;
}

const Sketched& ExactSketch() {
  static const Sketched sketched = Sketch(Views(), 0);
  return sketched;
}

const Sketched& NoisySketch() {
  static const Sketched sketched = Sketch(Views(), 0.3);
  return sketched;
}

DrawingResult Draw(const Sketched& sketched, const DrawingOptions& options, int num_threads = 2) {
  return BuildDrawing({{sketched.views, sketched.curves}, sketched.sketch}, options,
                      Threads(num_threads));
}

const DrawingResult& ExactDrawing() {
  static const DrawingResult drawn = Draw(ExactSketch(), {});
  return drawn;
}

const DrawingResult& NoisyDrawing() {
  static const DrawingResult drawn = Draw(NoisySketch(), {});
  return drawn;
}

int64_t Count(const StageSummary::Counts& counts, const std::string& name) {
  for (const auto& [unit, count] : counts) {
    if (unit == name) return count;
  }
  ADD_FAILURE() << "no count of " << name;
  return -1;
}

// Each corner has exactly one node of degree 3 within `max_footprints`, and there is no other
// junction.
void ExpectCubeCorners(const DrawingGraph& graph, double max_footprints) {
  int num_junctions = 0;
  for (const DrawingNode& node : graph.nodes) num_junctions += node.kind == NodeKind::kJunction;
  EXPECT_EQ(num_junctions, 8);
  for (const Eigen::Vector3d& corner : testing::CubeCorners(kHalfSide)) {
    const double radius = max_footprints * PixelFootprint(Views(), corner);
    int found = 0;
    for (const DrawingNode& node : graph.nodes) {
      if ((node.position_in_world - corner).norm() > radius) continue;
      ++found;
      EXPECT_EQ(node.Degree(), 3) << "at corner " << corner.transpose();
    }
    EXPECT_EQ(found, 1) << "nodes at corner " << corner.transpose();
  }
}

TauResult Evaluate(const DrawingGraph& graph, double tau) {
  CurveSet truth;
  truth.polylines = testing::Polylines(CubeWithCircle());
  EvaluationOptions options;
  options.taus = {tau};
  const TauResult row =
      EvaluateCurvesInFootprints(ToCurveSet(graph), truth, Views(), options).rows.at(0);
  ::testing::Test::RecordProperty("recall", std::to_string(row.recall.value()));
  ::testing::Test::RecordProperty("precision", std::to_string(row.precision.value()));
  ::testing::Test::RecordProperty("duplicated", std::to_string(row.duplicated.value()));
  ::testing::Test::RecordProperty("accuracy", std::to_string(row.accuracy.value()));
  return row;
}

void ExpectSamplesAccountedFor(const StageSummary& summary) {
  int64_t accounted = Count(summary.kept, "samples");
  for (const auto& [reason, count] : summary.dropped) {
    EXPECT_GE(count, 0) << reason;
    if (reason.rfind("samples:", 0) == 0) accounted += count;
  }
  EXPECT_GT(accounted, 0);
  EXPECT_EQ(accounted, Count(summary.in, "samples"));
}

void ExpectSameShape(const DrawingGraph& a, const DrawingGraph& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.links.size(), b.links.size());
  for (size_t n = 0; n < a.nodes.size(); ++n) {
    EXPECT_EQ(a.nodes[n].kind, b.nodes[n].kind);
    EXPECT_EQ(a.nodes[n].incident, b.nodes[n].incident);
  }
  for (size_t l = 0; l < a.links.size(); ++l) {
    EXPECT_EQ(a.links[l].node0, b.links[l].node0);
    EXPECT_EQ(a.links[l].node1, b.links[l].node1);
    EXPECT_EQ(a.links[l].closed, b.links[l].closed);
    ASSERT_EQ(a.links[l].points_in_world.size(), b.links[l].points_in_world.size()) << "link " << l;
    EXPECT_EQ(a.links[l].supporting_views, b.links[l].supporting_views);
  }
}

TEST(DrawingTest, ExactCubeIsAValidGraph) {
  EXPECT_TRUE(Validate(ExactDrawing().graph).empty()) << Validate(ExactDrawing().graph).front();
}

TEST(DrawingTest, ExactCubeHasItsCorners) { ExpectCubeCorners(ExactDrawing().graph, 2); }

TEST(DrawingTest, ExactCubeHasOneLinkPerCurve) {
  EXPECT_EQ(ExactDrawing().graph.links.size(), 13u);
  EXPECT_EQ(ExactDrawing().graph.nodes.size(), 9u);  // the corners and the circle's anchor
}

TEST(DrawingTest, CircleIsOneClosedLinkAtALoopAnchor) {
  const DrawingGraph& graph = ExactDrawing().graph;
  int num_closed = 0;
  for (const DrawingLink& link : graph.links) {
    if (!link.closed) continue;
    ++num_closed;
    EXPECT_EQ(link.node0, link.node1);
    EXPECT_EQ(graph.nodes.at(link.node0).kind, NodeKind::kLoopAnchor);
    EXPECT_NEAR(Length(link.points_in_world), 2 * M_PI * 0.45, 0.02);
  }
  EXPECT_EQ(num_closed, 1);
}

TEST(DrawingTest, ExactCubeIsCompleteAndWithoutDuplicates) {
  const TauResult row = Evaluate(ExactDrawing().graph, 1);
  EXPECT_GE(row.recall.value(), 0.97);
  EXPECT_GE(row.precision.value(), 0.97);
  EXPECT_LE(row.duplicated.value(), 0.05);
}

TEST(DrawingTest, EverySampleIsAccountedFor) {
  ExpectSamplesAccountedFor(ExactDrawing().summary);
  ExpectSamplesAccountedFor(NoisyDrawing().summary);
}

TEST(DrawingTest, ScaledSceneGivesTheScaledGraph) {
  static const Sketched sketched = Sketch(testing::Scaled(Views(), 1000), 0);
  const DrawingGraph scaled = Draw(sketched, {}).graph;
  const DrawingGraph& graph = ExactDrawing().graph;
  ASSERT_NO_FATAL_FAILURE(ExpectSameShape(graph, scaled));
  double largest = 0;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    for (size_t i = 0; i < graph.links[l].points_in_world.size(); ++i) {
      const Eigen::Vector3d& point = graph.links[l].points_in_world[i];
      largest = std::max(largest, (scaled.links[l].points_in_world[i] / 1000 - point).norm() /
                                      PixelFootprint(Views(), point));
    }
  }
  EXPECT_LT(largest, 1e-3);
}

TEST(DrawingTest, ResultDoesNotDependOnThreads) {
  const DrawingResult one = Draw(NoisySketch(), {}, 1);
  const DrawingGraph& two = NoisyDrawing().graph;
  EXPECT_EQ(one.summary.in, NoisyDrawing().summary.in);
  EXPECT_EQ(one.summary.kept, NoisyDrawing().summary.kept);
  EXPECT_EQ(one.summary.dropped, NoisyDrawing().summary.dropped);
  ASSERT_NO_FATAL_FAILURE(ExpectSameShape(one.graph, two));
  for (size_t l = 0; l < two.links.size(); ++l) {
    EXPECT_EQ(one.graph.links[l].points_in_world, two.links[l].points_in_world) << "link " << l;
    EXPECT_EQ(one.graph.links[l].sigma, two.links[l].sigma) << "link " << l;
  }
}

TEST(DrawingTest, NoisyCubeHasItsCorners) {
  EXPECT_TRUE(Validate(NoisyDrawing().graph).empty()) << Validate(NoisyDrawing().graph).front();
  ExpectCubeCorners(NoisyDrawing().graph, 2);
}

TEST(DrawingTest, NoisyCubeIsComplete) {
  const TauResult row = Evaluate(NoisyDrawing().graph, 1);
  EXPECT_GE(row.recall.value(), 0.95);
  EXPECT_LE(row.duplicated.value(), 0.05);
}

TEST(DrawingTest, SummaryTellsWhatWasTraced) {
  const StageSummary summary = Draw(ExactSketch(), {}).summary;
  EXPECT_GE(Count(summary.kept, "traced curves"), 13);
  EXPECT_EQ(Count(summary.kept, "traced curves that close"), 1);
}

TEST(DrawingTest, EverySampleHasTheFateOfTheSummary) {
  for (const DrawingResult* result : {&ExactDrawing(), &NoisyDrawing()}) {
    std::map<EdgelFate, int64_t> count;
    for (const auto& of_curve : result->fates) {
      for (const EdgelFate fate : of_curve) ++count[fate];
    }
    const StageSummary& summary = result->summary;
    EXPECT_EQ(count[EdgelFate::kDrawn], Count(summary.kept, "samples"));
    EXPECT_EQ(count[EdgelFate::kLostSupport],
              Count(summary.dropped, "samples: too few views after re-triangulation") +
                  Count(summary.dropped, "samples: piece too short after re-triangulation"));
    EXPECT_EQ(count[EdgelFate::kNotTraced], Count(summary.dropped, "samples: on no traced curve"));
    EXPECT_EQ(count[EdgelFate::kDoubtfulLink],
              Count(summary.dropped, "samples: in links with too little support"));
  }
}

TEST(DrawingTest, EmptySketchGivesEmptyGraph) {
  const DrawingResult result = Draw({Views(), ExactSketch().curves, {}}, {});
  EXPECT_TRUE(result.graph.links.empty());
  EXPECT_TRUE(result.graph.nodes.empty());
}

TEST(DrawingOptionsTest, LimitsOfTopologyAreChecked) {
  const auto is_valid = [](auto&& change) {
    DrawingOptions options;
    change(&options.topology);
    try {
      options.Check();
      return true;
    } catch (const OptionError&) {
      return false;
    }
  };
  EXPECT_TRUE(is_valid([](TopologyOptions*) {}));
  EXPECT_FALSE(is_valid([](TopologyOptions* o) { o->max_junction_gap_px = -1; }));
  EXPECT_FALSE(is_valid([](TopologyOptions* o) { o->max_continuation_angle_deg = 181; }));
}

}  // namespace
}  // namespace limn
