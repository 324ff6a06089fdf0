// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/evaluate_curves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/evaluation/plain_curves.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::Curves;
using testing::Line;

constexpr double kTau = 0.01;

TauResult EvaluateAtTau(const CurveSet& reconstruction, const CurveSet& truth,
                        EvaluationOptions options = {}, const CurveSet& dont_care = {}) {
  options.taus = {kTau};
  return EvaluateCurves(reconstruction, truth, options, dont_care).rows.at(0);
}

TEST(EvaluateCurves, LineWithinTauIsFoundAndBeyondIsNot) {
  const CurveSet truth = Curves({Line(0, 1)});
  const TauResult near = EvaluateAtTau(Curves({Line(0, 1, 0.99 * kTau)}), truth);
  EXPECT_DOUBLE_EQ(*near.precision, 1);
  EXPECT_DOUBLE_EQ(*near.recall, 1);
  EXPECT_DOUBLE_EQ(*near.f, 1);
  EXPECT_NEAR(*near.accuracy, 0.99 * kTau, 1e-9);
  EXPECT_NEAR(*near.completeness, 0.99 * kTau, 1e-9);
  const TauResult far = EvaluateAtTau(Curves({Line(0, 1, 1.01 * kTau)}), truth);
  EXPECT_DOUBLE_EQ(*far.precision, 0);
  EXPECT_DOUBLE_EQ(*far.recall, 0);
  EXPECT_DOUBLE_EQ(*far.f, 0);
}

TEST(EvaluateCurves, CurvesTooLongToBeSampledAreRefused) {
  const CurveSet truth = Curves({Line(0, 1)});
  for (const double length : {1e6, 1e12, 1e200}) {
    EXPECT_THROW(EvaluateAtTau(Curves({Line(0, length)}), truth), InputError) << length;
  }
}

TEST(EvaluateCurves, HalfCoveredTruthHasHalfRecall) {
  const CurveSet half = Curves({Line(0, 0.5)});
  const CurveSet whole = Curves({Line(0, 1)});
  const TauResult row = EvaluateAtTau(half, whole);
  EXPECT_DOUBLE_EQ(*row.precision, 1);
  EXPECT_NEAR(*row.recall, 0.5 + kTau, kTau / 4);
  const TauResult swapped = EvaluateAtTau(whole, half);
  EXPECT_NEAR(*swapped.precision, 0.5 + kTau, kTau / 4);
  EXPECT_DOUBLE_EQ(*swapped.recall, 1);
}

TEST(EvaluateCurves, PrecisionWeighsByLengthNotByVertices) {
  Polyline3d dense_but_wrong;
  for (int i = 0; i <= 1000; ++i) dense_but_wrong.push_back({i * 1e-4, 1, 0});  // length 0.1
  const TauResult row =
      EvaluateAtTau(Curves({Line(0, 0.9), dense_but_wrong}), Curves({Line(0, 1)}));
  EXPECT_NEAR(*row.precision, 0.9, 1e-9);
  EXPECT_NEAR(row.reconstructed_length, 1.0, 1e-9);
}

TEST(EvaluateCurves, SamplePrecisionCountsCopiesOnlyIfFalse) {
  const CurveSet truth = Curves({Line(0, 1), Line(0, 1, 5)});
  // Half of the truth is found twice; as long a false curve, once and twice.
  const TauResult once = EvaluateAtTau(Curves({Line(0, 1), Line(0, 1), Line(0, 1, 3)}), truth);
  EXPECT_NEAR(*once.precision, 2.0 / 3, 1e-9);
  EXPECT_NEAR(*once.sample_precision, 1.0 / 2, 1e-9);
  const TauResult twice = EvaluateAtTau(Curves({Line(0, 1), Line(0, 1, 3), Line(0, 1, 3)}), truth);
  EXPECT_NEAR(*twice.sample_precision, 1.0 / 3, 1e-9);
  EXPECT_FALSE(EvaluateAtTau({}, Curves({Line(0, 1)})).sample_precision);
}

TEST(EvaluateCurves, SeveralTausGiveARowEach) {
  EvaluationOptions options;
  options.taus = {0.01, 0.03};
  const EvaluationReport report =
      EvaluateCurves(Curves({Line(0, 1, 0.02)}), Curves({Line(0, 1)}), options);
  ASSERT_EQ(report.rows.size(), 2u);
  EXPECT_NEAR(*report.rows[0].precision, 0, 1e-9);
  EXPECT_DOUBLE_EQ(*report.rows[1].precision, 1);
}

TEST(EvaluateCurves, EveryTrueCopyCounts) {
  const CurveSet truth = Curves({Line(0, 1), Line(0, 1), Line(0, 1, 5)});
  EXPECT_NEAR(*EvaluateAtTau(Curves({Line(0, 1)}), truth).recall, 2.0 / 3, 1e-9);
}

TEST(EvaluateCurves, DuplicatesAreAbsentWhenNotAskedFor) {
  EvaluationOptions options;
  options.find_duplicates = false;
  const CurveSet copies = Curves({Line(0, 1), Line(0, 1)});
  EXPECT_FALSE(EvaluateAtTau(copies, copies, options).duplicated);
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(copies, copies).duplicated, 1);
}

TEST(EvaluateCurves, RegionClipsBothSets) {
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0, -1, -1), Eigen::Vector3d(1, 1, 1));
  // Outside the box: half of the truth, and a reconstruction of nothing.
  const TauResult row =
      EvaluateAtTau(Curves({Line(0, 1), Line(5, 7, 3)}), Curves({Line(0, 2)}), options);
  EXPECT_DOUBLE_EQ(*row.precision, 1);
  EXPECT_NEAR(*row.recall, 1, 1e-9);
  EXPECT_NEAR(row.true_length, 1, 1e-9);
}

TEST(EvaluateCurves, NothingCountsNearDontCareCurves) {
  const CurveSet reconstruction = Curves({Line(0, 1), Line(0, 1, 0.5)});
  const CurveSet truth = Curves({Line(0, 1)});
  EXPECT_NEAR(*EvaluateAtTau(reconstruction, truth).precision, 0.5, 1e-9);
  const CurveSet dont_care = Curves({Line(0, 1, 0.5 + 1.9 * kTau)});
  const TauResult row = EvaluateAtTau(reconstruction, truth, {}, dont_care);
  EXPECT_DOUBLE_EQ(*row.precision, 1);
  EXPECT_NEAR(row.reconstructed_length, 1, 1e-9);
  EvaluationOptions narrow;
  narrow.dont_care_taus = 1.8;
  EXPECT_NEAR(*EvaluateAtTau(reconstruction, truth, narrow, dont_care).precision, 0.5, 1e-9);
}

TEST(EvaluateCurves, PointsAsTruthAndAsReconstruction) {
  CurveSet points;
  for (int i = 0; i < 100; ++i) points.points.push_back({0.01 * i, i < 75 ? 0.0 : 1.0, 0});
  const CurveSet line = Curves({Line(0, 1)});
  const TauResult as_truth = EvaluateAtTau(line, points);
  EXPECT_DOUBLE_EQ(*as_truth.recall, 0.75);
  EXPECT_DOUBLE_EQ(as_truth.true_length, 100);
  const TauResult as_result = EvaluateAtTau(points, line);
  EXPECT_DOUBLE_EQ(*as_result.precision, 0.75);
  EXPECT_FALSE(as_result.duplicated);
}

TEST(EvaluateCurves, EmptyReconstructionHasNoPrecisionAndNoRecall) {
  const TauResult row = EvaluateAtTau({}, Curves({Line(0, 1)}));
  EXPECT_FALSE(row.precision);
  EXPECT_NEAR(*row.recall, 0, 1e-9);
  EXPECT_FALSE(row.completeness);
}

TEST(EvaluateCurves, BadInputIsRefused) {
  const CurveSet line = Curves({Line(0, 1)});
  EXPECT_THROW(EvaluateAtTau(line, {}), InputError);
  EXPECT_THROW(EvaluateAtTau(Curves({Line(0, NAN)}), line), InputError);
  EvaluationOptions options;
  EXPECT_THROW(EvaluateCurves(line, line, options), OptionError);
  options.taus = {0.01, -1};
  EXPECT_THROW(EvaluateCurves(line, line, options), OptionError);
}

TEST(EvaluateCurves, DuplicatedShareOfCopies) {
  const CurveSet truth = Curves({Line(0, 1)});
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(truth, truth).duplicated, 0);
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(Curves({Line(0, 1), Line(0, 1)}), truth).duplicated, 1);
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(Curves({Line(0, 1), Line(1, 0, 0.9 * kTau)}), truth).duplicated,
                   1);
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(Curves({Line(0, 1), Line(0, 1, 1.1 * kTau)}), truth).duplicated,
                   0);
  // A quarter of a line of length 1 has a copy of length 0.25: (0.25 + 0.25) / 1.25, but for the
  // tau at the copy's free ends.
  const TauResult part = EvaluateAtTau(Curves({Line(0, 1), Line(0.5, 0.75)}), truth);
  EXPECT_NEAR(*part.duplicated, (0.5 + 2 * kTau) / 1.25, kTau / 2);
}

TEST(EvaluateCurves, ContinuationsAndCrossingsAreNoDuplicates) {
  const CurveSet truth = Curves({Line(0, 1)});
  const CurveSet chain = Curves({Line(0, 0.3), Line(0.3, 0.303), Line(0.303, 1)});
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(chain, truth).duplicated, 0);
  const CurveSet crossing = Curves({Line(0, 1), {{0.5, -0.5, 0}, {0.5, 0.5, 0}}});
  EXPECT_DOUBLE_EQ(*EvaluateAtTau(crossing, truth).duplicated, 0);
  // Two links from one node that run back over each other are copies all the same.
  const CurveSet hairpin = Curves({Line(0, 1), {{1, 0, 0}, {0, 0.1 * kTau, 0}}});
  EXPECT_NEAR(*EvaluateAtTau(hairpin, truth).duplicated, 1, kTau);
}

TEST(EvaluateCurves, StructureOfTheReconstruction) {
  // A star of three links, and a closed triangle.
  const CurveSet set = Curves({{{0, 0, 0}, {1, 0, 0}},
                               {{0, 0, 0}, {0, 1, 0}},
                               {{0, 0, 1}, {0, 0, 0}},
                               {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 0}}});
  EvaluationOptions options;
  options.taus = {kTau};
  const EvaluationReport report = EvaluateCurves(set, set, options);
  EXPECT_EQ(report.num_links, 4);
  EXPECT_EQ(report.num_components, 2);
  EXPECT_NEAR(report.total_length, 3 + 2 + std::sqrt(2), 1e-12);
  EXPECT_EQ(report.nodes_by_degree, (std::map<int, int>{{1, 3}, {2, 1}, {3, 1}}));
  EXPECT_DOUBLE_EQ(*report.rows[0].junction_precision, 1);
  EXPECT_DOUBLE_EQ(*report.rows[0].junction_recall, 1);
}

TEST(EvaluateCurves, JunctionsAreMatchedWithinTwoTaus) {
  const auto star = [](double x, double y) {
    const Eigen::Vector3d center(x, y, 0);
    const Eigen::Vector3d dx(1, 0, 0), dy(0, 1, 0), dz(0, 0, 1);
    return std::vector<Polyline3d>{
        {center, center + dx}, {center, center + dy}, {center, center + dz}};
  };
  std::vector<Polyline3d> two = star(0, 0);
  for (const Polyline3d& link : star(10, 0)) two.push_back(link);
  const CurveSet truth = Curves(two);
  const TauResult near = EvaluateAtTau(Curves(star(1.9 * kTau, 0)), truth);
  EXPECT_DOUBLE_EQ(*near.junction_precision, 1);
  EXPECT_DOUBLE_EQ(*near.junction_recall, 0.5);
  const TauResult far = EvaluateAtTau(Curves(star(2.1 * kTau, 0)), truth);
  EXPECT_DOUBLE_EQ(*far.junction_precision, 0);
  EXPECT_DOUBLE_EQ(*far.junction_recall, 0);
}

std::vector<View> OneViewAtOrigin() {
  View view = testing::ForwardView();
  view.name = "a.png";
  return {view};
}

TEST(EvaluateCurvesInFootprints, DistancesAreInLocalPixels) {
  // At depth 10 a pixel is 0.1 wide, at depth 20 it is 0.2.
  const CurveSet truth = Curves({Line(-1, 1, 0, 10), Line(-1, 1, 0, 20)});
  const CurveSet shifted = Curves({Line(-1, 1, 0.15, 10), Line(-1, 1, 0.15, 20)});
  EvaluationOptions options;
  options.taus = {1.0};
  const EvaluationReport report =
      EvaluateCurvesInFootprints(shifted, truth, OneViewAtOrigin(), options);
  EXPECT_TRUE(report.in_footprints);
  EXPECT_NEAR(*report.rows[0].precision, 0.5, 1e-9);
  EXPECT_NEAR(*report.rows[0].recall, 0.5, 1e-9);
  EXPECT_NEAR(*report.rows[0].accuracy, 0.5 * (1.5 + 0.75), 1e-6);
}

TEST(EvaluateCurves, ThreadsDoNotMatter) {
  std::vector<Polyline3d> links;
  for (int i = 0; i < 50; ++i) {
    links.push_back({{0, 0.003 * i, 0}, {0.5, 0.01 * std::sin(i), 0.002 * i}, {1, 0.003 * i, 0.1}});
  }
  EvaluationOptions options;
  options.taus = {kTau};
  RunContext one, two;
  one.num_threads = 1;
  two.num_threads = 2;
  const CurveSet truth = Curves({Line(0, 1)});
  const TauResult a = EvaluateCurves(Curves(links), truth, options, {}, one).rows[0];
  const TauResult b = EvaluateCurves(Curves(links), truth, options, {}, two).rows[0];
  EXPECT_EQ(a.precision, b.precision);
  EXPECT_EQ(a.recall, b.recall);
  EXPECT_EQ(a.accuracy, b.accuracy);
  EXPECT_EQ(a.duplicated, b.duplicated);
  EXPECT_GT(*a.duplicated, 0);
}

}  // namespace
}  // namespace limn
