// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/shown_truth.h"

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::CubeEdges;
using testing::DomeViews;
using testing::Polylines;
using testing::ProjectCurves;
using testing::SceneCurve;

constexpr double kTruthDistance = 4;
constexpr double kTruthFootprint = kTruthDistance / 600;

// The images show the first half of the truth only.
class ShownTruthTest : public ::testing::Test {
 protected:
  ShownTruthTest() : views_(DomeViews(12, kTruthDistance)) {
    const std::vector<SceneCurve> edges = CubeEdges(0.5);
    truth_.polylines = Polylines(edges);
    curves_ = ProjectCurves(views_, {edges.begin(), edges.begin() + edges.size() / 2});
  }

  double Ceiling(const CurveSet& truth) const {
    EvaluationOptions options;
    options.taus = {2 * kTruthFootprint};
    const CurveSet shown = ShownTruth(truth, views_, curves_, {}, {});
    return EvaluateCurves(shown, truth, options).rows[0].recall.value();
  }

  std::vector<View> views_;
  std::vector<ImageCurves> curves_;
  CurveSet truth_;
};

TEST_F(ShownTruthTest, CeilingIsTheShareThatImagesShow) { EXPECT_NEAR(Ceiling(truth_), 0.5, 0.05); }

TEST_F(ShownTruthTest, PointsNeedNoDirection) {
  CurveSet points;
  for (const Polyline3d& edge : truth_.polylines) {
    for (const Eigen::Vector3d& point : ResampleUniform(edge, kTruthFootprint)) {
      points.points.push_back(point);
    }
  }
  EXPECT_NEAR(Ceiling(points), 0.5, 0.08);
}

TEST_F(ShownTruthTest, RegionAndNumberOfViewsLimit) {
  ShownTruthOptions options;
  options.min_views = 13;  // more than there are
  EXPECT_TRUE(ShownTruth(truth_, views_, curves_, options, {}).points.empty());
  options.min_views = 1;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(6, 6, 6));
  EXPECT_TRUE(ShownTruth(truth_, views_, curves_, options, {}).points.empty());
  options.min_views = 0;
  EXPECT_THROW(ShownTruth(truth_, views_, curves_, options, {}), OptionError);
}

}  // namespace
}  // namespace limn
