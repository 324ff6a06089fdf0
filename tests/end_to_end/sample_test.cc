// The main job on the whole sample scene with default options, judged against the truth.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/to_views.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/true_shapes.h"
#include "limn/evaluation/evaluate_curves.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/model/curve_set.h"
#include "limn/util/median.h"

namespace limn::testing {
namespace {

constexpr double kTauFootprints = 2;
// What is reached now is 0.96 and 0.89; 0.76 and 0.57 for junctions. The aims are 0.96 and 0.94 for
// curves, 0.90 and 0.80 for junctions: raise these with every step.
constexpr double kMinPrecision = 0.94;
constexpr double kMinRecall = 0.88;
// Of 141 junctions a few come and go with every change of the arithmetic: the same method gave
// precisions from 0.73 to 0.84 and recalls from 0.49 to 0.56.
constexpr double kMinJunctionPrecision = 0.70;
constexpr double kMinJunctionRecall = 0.50;
// What primitives reach, 0.90 and 0.88, less a margin.
constexpr double kMinLinesAsLines = 0.75;
constexpr double kMinCirclesAsCircles = 0.75;
constexpr double kMaxMedianDirectionDeg = 0.5;
constexpr double kMaxMedianRadiusError = 0.02;
// Squared errors over those that the sigmas tell are 1 in the mean, within this factor.
constexpr double kMaxVarianceFactor = 1.5;

// Distances are multiples of the pixel footprint; junctions are found within two taus.
EvaluationReport Judge(const DrawingGraph& graph) {
  const std::string truth_dir = LIMN_SAMPLE_DIR "/truth/";
  CurveSet truth = ReadCurves(truth_dir + "curves-visible.ply");
  truth.nodes = ReadJunctions(truth_dir + "junctions.json");
  colmap_ext::LayoutOptions paths;
  paths.workspace_path = LIMN_SAMPLE_DIR "/day";
  const colmap_ext::WorkspaceLayout layout = colmap_ext::ResolveLayout(paths);
  const colmap_ext::ViewSet set =
      colmap_ext::ToViews(colmap_ext::ReadModel(layout.model_dir), layout.image_dir, {});
  EvaluationOptions options;
  options.taus = {kTauFootprints};
  options.region =
      Eigen::AlignedBox3d(Eigen::Vector3d(-1.25, -0.95, 0.04), Eigen::Vector3d(1.25, 0.95, 1.05));
  const CurveSet dont_care = ReadCurves(truth_dir + "dont-care.ply");
  EvaluationReport report =
      EvaluateCurvesInFootprints(ToCurveSet(graph), truth, set.views, options, dont_care);
  NormalizedErrorOptions of_sigmas;
  of_sigmas.region = options.region;
  report.normalized_errors = MeasureNormalizedErrors(graph, truth, dont_care, set.views, of_sigmas);
  return report;
}

// The drawing, made once.
const DrawingGraph& Drawing() {
  static const DrawingGraph graph = [] {
    const TempDir dir;
    const LimnRun run = RunLimn({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                                 "--output_path", dir.path().string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return ReadDrawingJson((dir / "drawing.json").string()).graph;
  }();
  return graph;
}

TEST(Sample, DrawingAgreesWithTheTruth) {
  const EvaluationReport report = Judge(Drawing());
  const TauResult& result = report.rows.front();
  EXPECT_GE(result.precision.value(), kMinPrecision);
  EXPECT_GE(result.recall.value(), kMinRecall);
  EXPECT_GE(result.junction_precision.value(), kMinJunctionPrecision);
  EXPECT_GE(result.junction_recall.value(), kMinJunctionRecall);
  EXPECT_LE(report.normalized_errors->variance.value(), kMaxVarianceFactor);
  EXPECT_GE(report.normalized_errors->variance.value(), 1 / kMaxVarianceFactor);
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
