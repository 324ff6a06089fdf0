// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/rod_scores.h"

#include <gtest/gtest.h>

#include "limn/evaluation/plain_curves.h"
#include "limn/model/view.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::Curves;
using testing::Line;

constexpr double kRodTau = 0.01;
constexpr double kRodRadius = 0.02;
// Cells are at most kRodTau / 4 long.
constexpr double kRodCell = kRodTau / 4;

CurveSet RodsAlong(const std::vector<Polyline3d>& lines, double radius = kRodRadius) {
  CurveSet rods = Curves(lines);
  rods.rod_radii.assign(lines.size(), radius);
  return rods;
}

const CurveSet kNothing;
const CurveSet kTrueRod = RodsAlong({Line(0, 1)});
// Of which only the center line is known.
const CurveSet kThinTruth = Curves({Line(0, 1)});
const CurveSet kRodOutlines = Curves({Line(0, 1, kRodRadius), Line(0, 1, -kRodRadius)});

RodScores ScoreOne(const CurveSet& rods, const CurveSet& others, const CurveSet& truth,
                   EvaluationOptions options = {}) {
  options.taus = {kRodTau};
  return ScoreRods({rods, others, truth}, {}, options).at(0);
}

TEST(RodScores, RightRods) {
  const RodScores scores = ScoreOne(kTrueRod, kNothing, kTrueRod);
  EXPECT_NEAR(scores.true_length, 1, 1e-9);
  EXPECT_NEAR(scores.drawn_length, 1, 1e-9);
  EXPECT_EQ(scores.recall, 1);
  EXPECT_NEAR(*scores.links_per_length, 1, 1e-9);
  EXPECT_NEAR(*scores.false_per_length, 0, 1e-9);
  EXPECT_NEAR(*scores.median_error, 0, 1e-9);
  EXPECT_NEAR(*scores.median_radius_ratio, 1, 1e-9);
}

TEST(RodScores, RadiiAreComparedWhereTheTruthKnowsThem) {
  const CurveSet thick = RodsAlong({Line(0, 1)}, 1.5 * kRodRadius);
  EXPECT_NEAR(*ScoreOne(thick, kNothing, kTrueRod).median_radius_ratio, 1.5, 1e-9);
  EXPECT_FALSE(ScoreOne(thick, kNothing, kThinTruth).median_radius_ratio.has_value());
  CurveSet truth = RodsAlong({Line(0, 1), Line(0, 1, 1)});
  truth.rod_radii[0] = 0;
  EXPECT_FALSE(ScoreOne(thick, kNothing, truth).median_radius_ratio.has_value());
}

TEST(RodScores, BothOutlinesAreDrawnTwiceAndToldAsNone) {
  const RodScores scores = ScoreOne(kNothing, kRodOutlines, kTrueRod);
  EXPECT_EQ(scores.drawn_length, 0);
  EXPECT_EQ(scores.recall, 0);
  EXPECT_NEAR(*scores.links_per_length, 2, 1e-9);
  EXPECT_FALSE(scores.median_error.has_value());
  const RodScores all = ScoreOne(kTrueRod, kRodOutlines, kTrueRod);
  EXPECT_EQ(all.recall, 1);
  EXPECT_NEAR(*all.links_per_length, 3, 1e-9);
}

TEST(RodScores, LinksRunAlongWithinRadiusAndTau) {
  const auto share_at = [](double y) {
    return ScoreOne(kNothing, Curves({Line(0, 1, y)}), kTrueRod).links_per_length;
  };
  EXPECT_NEAR(*share_at(kRodRadius + 0.99 * kRodTau), 1, 1e-9);
  EXPECT_EQ(share_at(kRodRadius + 1.01 * kRodTau), 0);
  const Polyline3d across = {{0.5, -0.5, 0}, {0.5, 0.5, 0}};
  EXPECT_EQ(ScoreOne(kNothing, Curves({across}), kTrueRod).links_per_length, 0);
}

TEST(RodScores, WithoutTrueRadiiOnlyWhereADrawnRodTellsIt) {
  EXPECT_FALSE(ScoreOne(kNothing, kRodOutlines, kThinTruth).links_per_length.has_value());
  EXPECT_NEAR(*ScoreOne(kTrueRod, kRodOutlines, kThinTruth).links_per_length, 3, 1e-9);
  // Along half of it: what is beside the other half does not count, but near its end.
  const RodScores half = ScoreOne(RodsAlong({Line(0, 0.5)}), kRodOutlines, kThinTruth);
  EXPECT_NEAR(*half.links_per_length, 3, 0.2);
  // The true radius comes first.
  const CurveSet thick = RodsAlong({Line(0, 1)}, 5 * kRodRadius);
  const CurveSet beside = Curves({Line(0, 1, 4 * kRodRadius)});
  EXPECT_NEAR(*ScoreOne(thick, beside, kTrueRod).links_per_length, 1, 1e-9);
  EXPECT_NEAR(*ScoreOne(thick, beside, kThinTruth).links_per_length, 2, 1e-9);
}

TEST(RodScores, RodsMatchWithinTau) {
  const RodScores near = ScoreOne(RodsAlong({Line(0, 1, 0.9 * kRodTau)}), kNothing, kTrueRod);
  EXPECT_EQ(near.recall, 1);
  EXPECT_NEAR(*near.median_error, 0.9 * kRodTau, 1e-9);
  EXPECT_NEAR(*near.false_per_length, 0, 1e-9);
  // It is false, though it runs along.
  const RodScores far = ScoreOne(RodsAlong({Line(0, 1, 1.1 * kRodTau)}), kNothing, kTrueRod);
  EXPECT_EQ(far.recall, 0);
  EXPECT_FALSE(far.median_error.has_value());
  EXPECT_FALSE(far.median_radius_ratio.has_value());
  EXPECT_NEAR(*far.false_per_length, 1, 1e-9);
  EXPECT_NEAR(*far.links_per_length, 1, 1e-9);
}

TEST(RodScores, FalseRods) {
  const Polyline3d across = {{0.5, -0.5, 0}, {0.5, 0.5, 0}};
  const RodScores scores =
      ScoreOne(RodsAlong({Line(0, 2), Line(0, 0.25, 3), across}), kNothing, kTrueRod);
  EXPECT_EQ(scores.recall, 1);
  EXPECT_NEAR(scores.drawn_length, 3.25, 1e-9);
  EXPECT_NEAR(*scores.false_per_length, 2.25 - kRodTau, 2 * kRodCell);
  // Other links are no rods.
  EXPECT_NEAR(*ScoreOne(kTrueRod, Curves({Line(0, 1, 3)}), kTrueRod).false_per_length, 0, 1e-9);
}

TEST(RodScores, PartOfARod) {
  const RodScores scores = ScoreOne(RodsAlong({Line(0, 0.25)}), kNothing, kTrueRod);
  EXPECT_NEAR(*scores.recall, 0.25 + kRodTau, 2 * kRodCell);
  EXPECT_NEAR(*scores.links_per_length, 0.25, 1e-9);
}

TEST(RodScores, OnlyInsideTheRegion) {
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0.5, -1, -1), Eigen::Vector3d(2, 1, 1));
  const RodScores scores =
      ScoreOne(RodsAlong({Line(0, 0.75), Line(0, 1, 3)}), kRodOutlines, kTrueRod, options);
  EXPECT_NEAR(scores.true_length, 0.5, kRodCell);
  EXPECT_NEAR(scores.drawn_length, 0.25, kRodCell);
  EXPECT_NEAR(*scores.recall, 0.5 + 2 * kRodTau, 4 * kRodCell);
  EXPECT_NEAR(*scores.links_per_length, 2.5, 4 * kRodCell);
  EXPECT_NEAR(*scores.false_per_length, 0, 1e-9);
  options.region->min().x() = 1.5;
  EXPECT_EQ(ScoreOne(kTrueRod, kRodOutlines, kTrueRod, options).true_length, 0);
  EXPECT_FALSE(ScoreOne(kTrueRod, kRodOutlines, kTrueRod, options).recall.has_value());
}

TEST(RodScores, InFootprintsPerTau) {
  // At depth 1 a pixel is 0.01 wide.
  EvaluationOptions options;
  options.taus = {1, 2};
  const CurveSet truth = RodsAlong({Line(-0.5, 0.5, 0, 1)});
  const CurveSet rods = RodsAlong({Line(-0.5, 0.5, 0.015, 1)});
  const std::vector<RodScores> scores =
      ScoreRods({rods, kNothing, truth}, {testing::ForwardView()}, options);
  ASSERT_EQ(scores.size(), 2u);
  EXPECT_EQ(scores[0].recall, 0);
  EXPECT_NEAR(*scores[0].false_per_length, 1, 1e-9);
  EXPECT_EQ(scores[1].recall, 1);
  EXPECT_NEAR(*scores[1].median_error, 1.5, 1e-6);
  EXPECT_NEAR(scores[1].true_length, 1, 1e-9);
}

TEST(RodScores, TruthWithoutCurvesIsRefused) {
  CurveSet points;
  points.points = {{0, 0, 0}};
  EXPECT_THROW(ScoreOne(kTrueRod, kNothing, points), InputError);
}

TEST(RodsApartTest, IsByKind) {
  DrawingGraph drawing;
  drawing.nodes.resize(1);
  for (const double radius : {0.0, 0.25}) {
    DrawingLink link;
    link.points_in_world = {{0, 0, 0}, {1, radius, 0}};
    link.sigma = {0, 0};
    link.node0 = 0;
    link.node1 = static_cast<NodeId>(drawing.nodes.size());
    link.kind = radius > 0 ? LinkKind::kRod : LinkKind::kEdge;
    link.rod_radius = radius;
    drawing.nodes.emplace_back();
    drawing.nodes.back().position_in_world = link.points_in_world.back();
    drawing.links.push_back(link);
  }
  RebuildIncidence(&drawing);
  const RodsApart apart = TakeRodsApart(drawing);
  EXPECT_TRUE(Validate(apart.rods).empty());
  EXPECT_TRUE(Validate(apart.others).empty());
  EXPECT_EQ(ToCurveSet(apart.rods).rod_radii, std::vector<double>{0.25});
  ASSERT_EQ(apart.others.links.size(), 1u);
  EXPECT_EQ(apart.others.links[0].kind, LinkKind::kEdge);
}

}  // namespace
}  // namespace limn
