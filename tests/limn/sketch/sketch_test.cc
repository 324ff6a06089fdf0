#include "limn/sketch/sketch.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSide = 0.8;

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(16, 5);
  return views;
}

const std::vector<ImageCurves>& Curves() {
  static const std::vector<ImageCurves> curves =
      testing::ProjectCurves(Views(), testing::CubeEdges(kHalfSide));
  return curves;
}

using Generator = SketchResult (*)(const SketchInput&, const SketchOptions&, const RunContext&);

SketchResult RunSketch(Generator generator, std::optional<Eigen::AlignedBox3d> box = std::nullopt) {
  static const SceneHints no_hints;
  RunContext context;
  context.num_threads = 2;
  return generator({Views(), Curves(), no_hints, box}, SketchOptions(), context);
}

const SketchResult& Original() {
  static const SketchResult result = RunSketch(BuildOriginalSketch);
  return result;
}

const SketchResult& Enhanced() {
  static const SketchResult result = RunSketch(BuildEnhancedSketch);
  return result;
}

TauResult Evaluate(const CurveSketch& sketch, double tau) {
  CurveSet truth;
  truth.polylines = testing::Polylines(testing::CubeEdges(kHalfSide));
  EvaluationOptions options;
  options.taus = {tau};
  const TauResult row =
      EvaluateCurvesInFootprints(ToCurveSet(sketch), truth, Views(), options).rows.at(0);
  ::testing::Test::RecordProperty("recall", std::to_string(row.recall.value()));
  ::testing::Test::RecordProperty("precision", std::to_string(row.precision.value()));
  return row;
}

// Arrays of equal length, unit tangents along the curve, support sorted by view and with the
// anchor's own edgel.
void ExpectSound(const CurveSketch& sketch) {
  ASSERT_FALSE(sketch.curves.empty());
  for (const Curve3D& curve : sketch.curves) {
    ASSERT_GE(curve.size(), 2u);
    ASSERT_EQ(curve.tangents_in_world.size(), curve.size());
    ASSERT_EQ(curve.depth_sigma.size(), curve.size());
    ASSERT_EQ(curve.certain.size(), curve.size());
    ASSERT_EQ(curve.support.NumSamples(), curve.size());
    const auto& ids = Curves().at(curve.anchor.view).fragments.at(curve.anchor.fragment).edgel_ids;
    for (size_t s = 0; s < curve.size(); ++s) {
      EXPECT_NEAR(curve.tangents_in_world[s].norm(), 1, 1e-9);
      const EdgelRef own{curve.anchor.view, ids[(curve.anchor.begin + s) % ids.size()]};
      const auto support = curve.support.Of(s);
      EXPECT_TRUE(std::binary_search(support.begin(), support.end(), own));
      for (size_t k = 1; k < support.size(); ++k) EXPECT_LT(support[k - 1].view, support[k].view);
    }
  }
}

TEST(OriginalSketchTest, CurvesAreSound) { ExpectSound(Original().sketch); }

TEST(OriginalSketchTest, FindsMostOfTheCube) {
  EXPECT_GE(Evaluate(Original().sketch, 2).recall.value(), 0.8);
}

TEST(EnhancedSketchTest, CurvesAreSound) { ExpectSound(Enhanced().sketch); }

TEST(EnhancedSketchTest, FindsTheCubePrecisely) {
  const TauResult row = Evaluate(Enhanced().sketch, 1);
  EXPECT_GE(row.recall.value(), 0.97);
  EXPECT_GE(row.precision.value(), 0.95);
}

TEST(EnhancedSketchTest, ReconstructsOnlyInsideTheBox) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-2, -2, 0.1), Eigen::Vector3d(2, 2, 2));
  const CurveSketch sketch = RunSketch(BuildEnhancedSketch, box).sketch;
  ASSERT_FALSE(sketch.curves.empty());
  // Samples between two inside are inside too; fitting may move them by a fraction of a pixel.
  for (const Curve3D& curve : sketch.curves) {
    for (const Eigen::Vector3d& point : curve.points_in_world) EXPECT_GT(point.z(), 0.1 - 0.01);
  }
}

TEST(EnhancedSketchTest, ThreadsDoNotMatter) {
  const SceneHints no_hints;
  RunContext one;
  one.num_threads = 1;
  const SketchResult result =
      BuildEnhancedSketch({Views(), Curves(), no_hints, std::nullopt}, SketchOptions(), one);
  ASSERT_EQ(result.sketch.curves.size(), Enhanced().sketch.curves.size());
  for (size_t c = 0; c < result.sketch.curves.size(); ++c) {
    EXPECT_EQ(result.sketch.curves[c].points_in_world, Enhanced().sketch.curves[c].points_in_world);
    EXPECT_EQ(result.sketch.curves[c].support.edgels, Enhanced().sketch.curves[c].support.edgels);
  }
}

}  // namespace
}  // namespace limn
