// SPDX-License-Identifier: BSD-3-Clause
// The main job on the whole sample scene with default options, in fixed and in mixed light, and the
// sketches of the paper, judged against the truth.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/true_shapes.h"
#include "limn/alignment/drawing_span.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/model/curve_set.h"
#include "limn/model/link_selection.h"
#include "limn/util/median.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;

constexpr double kTauFootprints = 2;
// What is reached now is 0.963 and 0.895; 0.78 and 0.63 for junctions. The aims are 0.96 and 0.94
// for curves, 0.90 and 0.80 for junctions: raise these with every step.
constexpr double kMinPrecision = 0.948;
constexpr double kMinRecall = 0.88;
// 0.950 and 0.902 now; F is 0.926, of day 0.928.
constexpr double kMinMixedPrecision = 0.935;
constexpr double kMinMixedRecall = 0.887;
constexpr double kMinShareOfFixedLight = 0.95;
// Of F, from sketch to sketch and to the drawing.
constexpr double kMinGain = 0.02;
// Of 141 junctions a few come and go with every change of the arithmetic: the same method gave
// precisions from 0.73 to 0.84 and recalls from 0.49 to 0.56.
constexpr double kMinJunctionPrecision = 0.70;
constexpr double kMinJunctionRecall = 0.50;
// What primitives reach, 0.90 and 0.88, less a margin.
constexpr double kMinLinesAsLines = 0.75;
constexpr double kMinCirclesAsCircles = 0.75;
constexpr double kMaxMedianDirectionDeg = 0.5;
constexpr double kMaxMedianRadiusError = 0.02;
// Squared errors over those predicted by the sigmas are 1 on average, within this factor.
constexpr double kMaxVarianceFactor = 1.5;

// One of the sample's sets of photographs.
fs::path SetDir(const std::string& set) { return fs::path(LIMN_SAMPLE_DIR) / set; }

// What that set shows.
fs::path TruthDir(const std::string& set) {
  const fs::path truth = fs::path(LIMN_SAMPLE_DIR) / "truth";
  return set == "day" ? truth : truth / set;
}

CurveSet DontCare(const std::string& set) {
  return ReadCurves((TruthDir(set) / "dont-care.ply").string());
}

std::vector<View> ViewsOf(const std::string& set) {
  colmap_ext::LayoutOptions paths;
  paths.workspace_path = SetDir(set).string();
  const colmap_ext::WorkspaceLayout layout = colmap_ext::ResolveLayout(paths);
  return colmap_ext::ToViews(colmap_ext::ReadModel(layout.model_dir), layout.image_dir, {}).views;
}

EvaluationOptions Judgement() {
  EvaluationOptions options;
  options.taus = {kTauFootprints};
  options.find_duplicates = false;
  options.region =
      Eigen::AlignedBox3d(Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05));
  return options;
}

// Distances are multiples of the pixel footprint; junctions are found within two taus.
TauResult Judge(const CurveSet& curves, const std::string& set) {
  CurveSet truth = ReadCurves((TruthDir(set) / "curves-visible.ply").string());
  truth.nodes = ReadJunctions((TruthDir(set) / "junctions.json").string());
  return EvaluateCurvesInFootprints(curves, truth, ViewsOf(set), Judgement(), DontCare(set))
      .rows.front();
}

// A folder in which all commands share the image curves of a set.
fs::path OutputOf(const std::string& set) {
  static const TempDir shared;
  return shared / set;
}

void RunOn(const std::string& set, const std::vector<std::string>& arguments) {
  std::vector<std::string> all = arguments;
  all.insert(all.end(),
             {"--workspace_path", SetDir(set).string(), "--output_path", OutputOf(set).string()});
  const LimnRun run = RunLimn(all);
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

// The drawing of a set, made once.
const DrawingGraph& Drawing(const std::string& set = "day") {
  static std::map<std::string, DrawingGraph> drawings;
  if (!drawings.contains(set)) {
    RunOn(set, {"automatic_drawer", "--page", "0"});
    drawings[set] = ReadDrawingJson((OutputOf(set) / "drawing.json").string()).graph;
  }
  return drawings[set];
}

// Without tentative links and outlines of smooth bodies, as drawing_evaluator judges.
const TauResult& Result(const std::string& set) {
  static std::map<std::string, TauResult> results;
  if (!results.contains(set)) {
    results[set] = Judge(ToCurveSet(Selected(Drawing(set), LinkSelection::AsSeen())), set);
  }
  return results[set];
}

TEST(Sample, DrawingAgreesWithTheTruth) {
  const TauResult& result = Result("day");
  EXPECT_GE(result.precision.value(), kMinPrecision);
  EXPECT_GE(result.recall.value(), kMinRecall);
  EXPECT_GE(result.junction_precision.value(), kMinJunctionPrecision);
  EXPECT_GE(result.junction_recall.value(), kMinJunctionRecall);
}

TEST(Sample, SigmasTellTheErrors) {
  NormalizedErrorOptions options;
  options.region = Judgement().region;
  const CurveSet truth = ReadCurves((TruthDir("day") / "curves-visible.ply").string());
  const auto errors =
      MeasureNormalizedErrors(Drawing(), truth, DontCare("day"), ViewsOf("day"), options);
  EXPECT_LE(errors.variance.value(), kMaxVarianceFactor);
  EXPECT_GE(errors.variance.value(), 1 / kMaxVarianceFactor);
}

// The nodes that stand for junctions, each the nearest of the other, with the place of that.
std::map<NodeId, Eigen::Vector3d> NodesAtJunctions(const DrawingGraph& graph,
                                                   const std::vector<CurveNode>& junctions) {
  constexpr double kMaxDistanceM = 0.01;  // two pixels
  const auto nearest = [](const Eigen::Vector3d& to, const auto& nodes, const auto& place_of) {
    return static_cast<NodeId>(
        std::ranges::min_element(
            nodes, {}, [&](const auto& node) { return (place_of(node) - to).squaredNorm(); }) -
        nodes.begin());
  };
  const auto of_node = [](const DrawingNode& node) { return node.position_in_world; };
  const auto of_junction = [](const CurveNode& junction) { return junction.position_in_world; };
  std::map<NodeId, Eigen::Vector3d> found;
  for (NodeId n = 0; n < static_cast<NodeId>(graph.nodes.size()); ++n) {
    const Eigen::Vector3d& place = graph.nodes[n].position_in_world;
    const Eigen::Vector3d& truth =
        junctions[nearest(place, junctions, of_junction)].position_in_world;
    if ((truth - place).norm() < kMaxDistanceM && nearest(truth, graph.nodes, of_node) == n) {
      found[n] = truth;
    }
  }
  return found;
}

// Of all lengths between two nodes that stand for junctions: 0.68 if sigmas are right; 0.82 now, by
// lamp light 0.75, of other scenes 0.69 to 0.80 (algorithm/belief.md#nodes).
TEST(Sample, SigmasTellTheErrorsOfLengths) {
  const DrawingGraph graph = Selected(Drawing(), {});
  const auto places =
      NodesAtJunctions(graph, ReadJunctions((TruthDir("day") / "junctions.json").string()));
  ASSERT_GT(places.size(), 80u);
  double num_lengths = 0, num_within = 0;
  for (const auto& [a, true_a] : places) {
    for (const auto& [b, true_b] : places) {
      if (b <= a) continue;
      const MeasuredLength measured = MeasureSpan(graph, {.node0 = a, .node1 = b});
      ASSERT_GT(measured.sigma, 0);
      ++num_lengths;
      num_within += std::abs(measured.length - (true_b - true_a).norm()) <= measured.sigma;
    }
  }
  EXPECT_GE(num_within, 0.58 * num_lengths);
  EXPECT_LE(num_within, 0.88 * num_lengths);
}

// Each image by day, in the evening or by lamp light: what the method is for.
TEST(Sample, MixedLightIsNearlyAsGoodAsFixed) {
  const TauResult& result = Result("mixed");
  EXPECT_GE(result.precision.value(), kMinMixedPrecision);
  EXPECT_GE(result.recall.value(), kMinMixedRecall);
  EXPECT_GE(result.f.value(), kMinShareOfFixedLight * Result("day").f.value());
}

// F from the precision of the paper, in samples: copies of right curves are no gain.
double SampleF(const TauResult& result) {
  const double precision = result.sample_precision.value();
  return 2 * precision * result.recall.value() / (precision + result.recall.value());
}

// The order of the paper's figures.
TEST(Sample, EveryStepOfThePaperIsAGain) {
  const auto f_of_sketch = [](const std::string& mode, const std::string& file) {
    RunOn("mixed", {"curve_sketcher", "--mode", mode});
    return SampleF(Judge(ReadCurves((OutputOf("mixed") / "curves" / file).string()), "mixed"));
  };
  const double drawing = SampleF(Result("mixed"));
  const double enhanced = f_of_sketch("enhanced", "enhanced-sketch.ply");
  const double original = f_of_sketch("original", "sketch.ply");
  EXPECT_LT(original + kMinGain, enhanced);
  EXPECT_LT(enhanced + kMinGain, drawing);
}

TEST(Sample, EveryPointHasAFiniteSigma) {
  EXPECT_FALSE(Drawing().links.empty());
  for (const DrawingLink& link : Drawing().links) {
    for (const double sigma : link.sigma) ASSERT_TRUE(std::isfinite(sigma));
  }
}

TEST(Sample, StraightEdgesAreLinesAndCirclesAreCircles) {
  // Two pixels where the objects are; long lines have 25 px and more.
  const ShapeAgreement shapes =
      CompareShapes(Drawing(), LIMN_SAMPLE_DIR "/truth/curves.ply", 0.01, 0.1);
  ASSERT_GT(shapes.length_on_lines, 30);
  EXPECT_GE(shapes.lines_as_lines, kMinLinesAsLines * shapes.length_on_lines);
  ASSERT_GT(shapes.length_on_circles, 4);
  EXPECT_GE(shapes.circles_as_circles, kMinCirclesAsCircles * shapes.length_on_circles);
  ASSERT_FALSE(shapes.direction_errors_deg.empty());
  EXPECT_LE(Median(shapes.direction_errors_deg), kMaxMedianDirectionDeg);
  ASSERT_FALSE(shapes.radius_errors.empty());
  EXPECT_LE(Median(shapes.radius_errors), kMaxMedianRadiusError);
}

}  // namespace
}  // namespace limn::testing
