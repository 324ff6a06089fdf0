// SPDX-License-Identifier: BSD-3-Clause
// How curves are cut and joined: scores of hand-made sets.
#include "limn/evaluation/structure_scores.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/plain_curves.h"
#include "limn/model/view.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::Curves;
using testing::Line;

// Nodes match within 0.02, chains count from 0.1, links cover from 0.025, arms are 0.04 long.
constexpr double kStructureTau = 0.01;

Eigen::Vector3d At(double angle_deg, double radius = 1) {
  return {radius * std::cos(angle_deg * kDeg), radius * std::sin(angle_deg * kDeg), 0};
}

// Lines of length 1 from the origin in these directions.
CurveSet Star(const std::vector<double>& angles_deg) {
  CurveSet star;
  for (const double angle : angles_deg) {
    star.polylines.push_back({Eigen::Vector3d::Zero(), At(angle)});
  }
  return star;
}

// With an end `gap` before the origin.
Polyline3d Arm(double angle_deg, double gap) { return {At(angle_deg, gap), At(angle_deg)}; }

Polyline3d Circle(double radius) {
  Polyline3d circle;
  for (int i = 0; i < 72; ++i) circle.push_back(At(5 * i, radius));
  circle.push_back(circle.front());
  return circle;
}

StructureScores Score(const CurveSet& reconstruction, const CurveSet& truth,
                      EvaluationOptions options = {}, const CurveSet& dont_care = {}) {
  options.taus = {kStructureTau};
  return EvaluateCurves(reconstruction, truth, options, dont_care).rows.at(0).structure;
}

TEST(LinksPerChain, PiecesThatCoverEnoughCount) {
  const CurveSet truth = Curves({Line(0, 1)});
  EXPECT_EQ(Score(truth, truth).links_per_chain, 1.0);
  EXPECT_EQ(Score(Curves({Line(0, 0.6), Line(0.6, 1)}), truth).links_per_chain, 2.0);
  EXPECT_EQ(Score(Curves({Line(0, 0.6), Line(0.6, 0.98), Line(0.98, 1)}), truth).links_per_chain,
            2.0);
  EXPECT_EQ(Score(Curves({Line(0, 0.6), Line(0.6, 0.97), Line(0.97, 1)}), truth).links_per_chain,
            3.0);
}

TEST(CurvesPerChain, LinksThatContinueEachOtherAreOne) {
  const CurveSet truth = Curves({Line(0, 1)});
  CurveSet drawn = Curves({Line(0, 0.5), Line(0.5, 0.75), Line(0.75, 1)});
  EXPECT_EQ(Score(drawn, truth).curves_per_chain, 3.0);
  drawn.curves = {0, 1, 0};
  EXPECT_EQ(Score(drawn, truth).curves_per_chain, 2.0);
  EXPECT_EQ(Score(drawn, truth).links_per_chain, 3.0);
}

TEST(CurvesPerChain, CoverAChainByTheirLinksTogether) {
  const CurveSet truth = Curves({Line(0, 1)});
  CurveSet drawn = Curves({Line(0, 0.96), Line(0.96, 0.98), Line(0.98, 1)});
  EXPECT_EQ(Score(drawn, truth).curves_per_chain, 1.0);
  drawn.curves = {0, 1, 1};
  EXPECT_EQ(Score(drawn, truth).curves_per_chain, 2.0);
  EXPECT_EQ(Score(drawn, truth).links_per_chain, 1.0);
}

TEST(LinksPerChain, AreTheMeanByLengthOverDrawnChains) {
  const CurveSet truth = Curves({Line(0, 3), Line(0, 1, 1), Line(0, 5, 2)});
  const StructureScores scores =
      Score(Curves({Line(0, 3), Line(0, 0.5, 1), Line(0.5, 1, 1)}), truth);
  EXPECT_NEAR(*scores.links_per_chain, (3 * 1 + 1 * 2) / 4.0, 1e-9);
  EXPECT_EQ(scores.num_chains, 3);
  EXPECT_EQ(scores.num_drawn_chains, 2);
}

TEST(LinksPerChain, ShortChainsDoNotCount) {
  const CurveSet truth = Curves({Line(0, 0.09), Line(0, 0.11, 1)});
  const StructureScores scores = Score(truth, truth);
  EXPECT_EQ(scores.num_chains, 1);
  EvaluationOptions options;
  options.chain_taus = 5;
  EXPECT_EQ(Score(truth, truth, options).num_chains, 2);
  options.cover_taus = 20;
  EXPECT_EQ(Score(truth, truth, options).num_drawn_chains, 0);
  options.cover_taus = -1;
  EXPECT_THROW(Score(truth, truth, options), OptionError);
}

TEST(LinksPerChain, CrossingAndDistantLinksAreNotOnTheChain) {
  const CurveSet truth = Curves({Line(0, 1)});
  // At 30 degrees: 0.04 of it is within tau of the chain.
  const Polyline3d across = {{0.5 - std::cos(30 * kDeg), -0.5, 0},
                             {0.5 + std::cos(30 * kDeg), 0.5, 0}};
  EXPECT_EQ(
      Score(Curves({Line(0, 1), across, Line(0, 1, 1.1 * kStructureTau)}), truth).links_per_chain,
      1.0);
  EXPECT_EQ(Score(Curves({Line(0, 1), Line(0, 1, 0.9 * kStructureTau)}), truth).links_per_chain,
            2.0);
}

TEST(LinksPerChain, LinksAreOnTheNearestChainOnly) {
  const CurveSet truth = Curves({Line(0, 1), Line(0, 1, 0.8 * kStructureTau)});
  const StructureScores scores = Score(Curves({Line(0, 1, 0.1 * kStructureTau)}), truth);
  EXPECT_EQ(scores.num_drawn_chains, 1);
  EXPECT_EQ(scores.links_per_chain, 1.0);
}

TEST(LinksPerChain, OneLinkMayCoverSeveralChains) {
  const CurveSet corner = Curves({{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}});
  const StructureScores scores = Score(corner, corner);
  EXPECT_EQ(scores.num_chains, 2);
  EXPECT_EQ(scores.links_per_chain, 1.0);
}

TEST(LinksPerChain, RegionCutsChains) {
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0, -1, -1), Eigen::Vector3d(0.5, 1, 1));
  const CurveSet truth = Curves({Line(0, 1), Line(0.45, 1, 0.5)});
  const StructureScores scores =
      Score(Curves({Line(0, 0.6), Line(0.6, 1), Line(0.45, 1, 0.5)}), truth, options);
  EXPECT_EQ(scores.num_chains, 1);
  EXPECT_EQ(scores.links_per_chain, 1.0);
}

TEST(FreeEnds, AreFalseFarFromTrueEnds) {
  const CurveSet truth = Curves({Line(0, 2)});
  const StructureScores half = Score(Curves({Line(0, 1)}), truth);
  EXPECT_EQ(half.num_free_ends, 2);
  EXPECT_EQ(half.num_false_ends, 1);
  EXPECT_NEAR(*half.false_ends_per_length, 0.5, 1e-9);
  EXPECT_EQ(Score(Curves({Line(0.019, 1.981)}), truth).num_false_ends, 0);
  EXPECT_EQ(Score(Curves({Line(0.021, 1.979)}), truth).num_false_ends, 2);
}

TEST(FreeEnds, AtCornersAndJunctionsAreRight) {
  const CurveSet corner = Curves({{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}});
  EXPECT_EQ(Score(Curves({Arm(0, 0), Arm(90, 0.01)}), corner).num_false_ends, 0);
  const CurveSet tee = Curves({Line(-1, 1), {{0, 0, 0}, {0, 1, 0}}});
  EXPECT_EQ(Score(Curves({Line(-1, 1), Arm(90, 0.01)}), tee).num_false_ends, 0);
  EXPECT_EQ(Score(Curves({Line(-1, 1), Arm(90, 0.05)}), tee).num_false_ends, 1);
}

TEST(FreeEnds, ClosedCurvesHaveNone) {
  const CurveSet circle = Curves({Circle(1)});
  EXPECT_EQ(Score(circle, circle).num_free_ends, 0);
  // Any end on a closed true curve is false.
  Polyline3d open = circle.polylines[0];
  open.pop_back();
  EXPECT_EQ(Score(Curves({open}), circle).num_false_ends, 2);
}

TEST(FreeEnds, NearDontCareAndOutsideTheRegionDoNotCount) {
  const CurveSet truth = Curves({Line(0, 2)});
  const CurveSet drawn = Curves({Line(0.5, 1), Line(1.5, 1.9)});
  EXPECT_EQ(Score(drawn, truth).num_false_ends, 4);
  const StructureScores ignoring = Score(drawn, truth, {}, Curves({Line(0.9, 1.1, 0.019)}));
  EXPECT_EQ(ignoring.num_free_ends, 3);
  EXPECT_EQ(ignoring.num_false_ends, 3);
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0, -1, -1), Eigen::Vector3d(1.7, 1, 1));
  EXPECT_EQ(Score(drawn, truth, options).num_false_ends, 3);
}

TEST(FalseJunctions, AreFarFromTrueOnes) {
  const CurveSet star = Star({0, 90, 180});
  const StructureScores right = Score(star, star);
  EXPECT_EQ(right.num_false_junctions, 0);
  EXPECT_EQ(right.false_junctions_per_length, 0.0);
  const CurveSet line = Curves({Line(-1, 1)});
  const StructureScores wrong = Score(star, line);
  EXPECT_EQ(wrong.num_false_junctions, 1);
  EXPECT_NEAR(*wrong.false_junctions_per_length, 0.5, 1e-9);
  EXPECT_EQ(wrong.num_matched_junctions, 0);
  EXPECT_FALSE(wrong.right_degrees.has_value());
  EXPECT_FALSE(wrong.arm_precision.has_value());
  EXPECT_FALSE(wrong.arm_recall.has_value());
  // Corners are no junctions.
  EXPECT_EQ(Score(star, Curves({{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}})).num_false_junctions, 1);
  EXPECT_EQ(Score(star, line, {}, Curves({Line(-0.1, 0.1)})).num_false_junctions, 0);
}

TEST(FalseJunctions, AreCountedWhereTheTruthHasNone) {
  EvaluationOptions options;
  options.taus = {kStructureTau};
  const TauResult row =
      EvaluateCurves(Star({0, 90, 180}), Curves({Line(-1, 1)}), options).rows.at(0);
  EXPECT_EQ(row.num_junctions, 1);
  EXPECT_EQ(row.structure.num_false_junctions, 1);
  EXPECT_FALSE(row.junction_precision.has_value());
}

TEST(MatchedJunctions, DegreesAndArms) {
  const CurveSet truth = Star({0, 90, 180});
  const StructureScores right = Score(truth, truth);
  EXPECT_EQ(right.num_matched_junctions, 1);
  EXPECT_EQ(right.right_degrees, 1.0);
  EXPECT_EQ(right.arm_precision, 1.0);
  EXPECT_EQ(right.arm_recall, 1.0);
  const StructureScores one_more = Score(Star({0, 90, 180, 270}), truth);
  EXPECT_EQ(one_more.right_degrees, 0.0);
  EXPECT_EQ(one_more.arm_precision, 0.75);
  EXPECT_EQ(one_more.arm_recall, 1.0);
  const StructureScores one_less = Score(truth, Star({0, 90, 180, 270}));
  EXPECT_EQ(one_less.right_degrees, 0.0);
  EXPECT_EQ(one_less.arm_precision, 1.0);
  EXPECT_EQ(one_less.arm_recall, 0.75);
}

TEST(MatchedJunctions, ArmsMatchWithin20DegreesOneToOne) {
  const CurveSet truth = Star({0, 90, 180});
  EXPECT_EQ(Score(Star({0, 71, 180}), truth).arm_recall, 1.0);
  EXPECT_NEAR(*Score(Star({0, 69, 180}), truth).arm_recall, 2.0 / 3, 1e-9);
  // Two for one.
  const StructureScores twice = Score(Star({0, 85, 95}), truth);
  EXPECT_EQ(twice.right_degrees, 1.0);
  EXPECT_NEAR(*twice.arm_precision, 2.0 / 3, 1e-9);
  EXPECT_NEAR(*twice.arm_recall, 2.0 / 3, 1e-9);
}

TEST(MatchedJunctions, AreOneToOne) {
  // Two drawn junctions within reach of the true one: the nearer is its match.
  CurveSet drawn = Star({0, 90, 180, 270});
  for (const double angle : {30.0, 150.0, 210.0}) {
    drawn.polylines.push_back({{0.01, 0, 0}, At(angle)});
  }
  const StructureScores scores = Score(drawn, Star({0, 90, 180, 270}));
  EXPECT_EQ(scores.num_matched_junctions, 1);
  EXPECT_EQ(scores.right_degrees, 1.0);
  EXPECT_EQ(scores.num_false_junctions, 0);
}

TEST(MatchedJunctions, TruthMayTellItsDegrees) {
  CurveSet truth = Star({0, 90, 180});
  truth.nodes = {{Eigen::Vector3d::Zero(), 4}};
  const StructureScores scores = Score(Star({0, 90, 180, 270}), truth);
  EXPECT_EQ(scores.right_degrees, 1.0);
  EXPECT_EQ(scores.arm_precision, 0.75);
}

TEST(MatchedJunctions, ShortTrueEdgesAreNotTakenForArms) {
  CurveSet truth = Star({0, 90, 180});
  truth.polylines[1][1] = At(90, 0.019);
  EXPECT_EQ(Score(Star({0, 90, 180}), truth).num_matched_junctions, 0);
  EXPECT_EQ(Score(Star({0, 90, 180}), truth).num_false_junctions, 0);
  truth.polylines[1][1] = At(90, 0.021);
  EXPECT_EQ(Score(Star({0, 90, 180}), truth).num_matched_junctions, 1);
}

TEST(Connectivity, OfACorner) {
  const CurveSet corner = Curves({{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}});
  const StructureScores one_link = Score(corner, corner);
  EXPECT_EQ(one_link.num_drawn_meetings, 1);
  EXPECT_EQ(one_link.connectivity, 1.0);
  EXPECT_EQ(Score(Star({0, 90}), corner).connectivity, 1.0);
  EXPECT_EQ(Score(Curves({Arm(0, 0.004), Arm(90, 0.004)}), corner).connectivity, 0.0);
  // By a third link, whose nodes are within 0.01 of the corner or not.
  EvaluationOptions options;
  options.junction_taus = 1;
  const auto joined_by_third = [&](double gap) {
    return Score(Curves({Arm(0, gap), Arm(90, gap), {At(0, gap), At(90, gap)}}), corner, options)
        .connectivity;
  };
  EXPECT_EQ(joined_by_third(0.009), 1.0);
  EXPECT_EQ(joined_by_third(0.011), 0.0);
}

TEST(Connectivity, CountsPairsThatAreDrawn) {
  const CurveSet truth = Star({0, 90, 180});
  EXPECT_EQ(Score(truth, truth).num_drawn_meetings, 3);
  EXPECT_EQ(Score(truth, truth).connectivity, 1.0);
  // The third arm does not reach the node.
  const StructureScores apart = Score(Curves({Line(-1, 1), Arm(90, 0.01)}), truth);
  EXPECT_EQ(apart.num_drawn_meetings, 3);
  EXPECT_NEAR(*apart.connectivity, 1.0 / 3, 1e-9);
  // The third arm begins too far away to be drawn there.
  const StructureScores two = Score(Curves({Line(-1, 1), Arm(90, 0.025)}), truth);
  EXPECT_EQ(two.num_drawn_meetings, 1);
  EXPECT_EQ(two.connectivity, 1.0);
  const StructureScores one = Score(Curves({Line(0, 1)}), truth);
  EXPECT_EQ(one.num_drawn_meetings, 0);
  EXPECT_FALSE(one.connectivity.has_value());
}

TEST(Connectivity, NodesOutsideTheRegionDoNotCount) {
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(0.1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const CurveSet star = Star({0, 90, 180});
  const StructureScores scores = Score(star, star, options);
  EXPECT_EQ(scores.num_drawn_meetings, 0);
  EXPECT_EQ(scores.num_matched_junctions, 0);
}

TEST(StructureScores, AreTheSameInFootprintsOfTheSameSize) {
  // At depth 1 a pixel is 0.01 = kStructureTau wide.
  View view = testing::ForwardView();
  CurveSet truth = Star({0, 90, 180});
  CurveSet drawn = Curves({Line(-1, 0.5), Line(0.5, 1), Arm(90, 0.01)});
  for (CurveSet* set : {&truth, &drawn}) {
    for (Polyline3d& polyline : set->polylines) {
      for (Eigen::Vector3d& point : polyline) point.z() = 1;
    }
  }
  EvaluationOptions options;
  options.taus = {1.0};
  const StructureScores scores =
      EvaluateCurvesInFootprints(drawn, truth, {view}, options).rows.at(0).structure;
  const StructureScores expected = Score(drawn, truth);
  EXPECT_NEAR(*scores.links_per_chain, *expected.links_per_chain, 1e-9);
  EXPECT_EQ(scores.num_chains, expected.num_chains);
  EXPECT_EQ(scores.num_false_ends, expected.num_false_ends);
  EXPECT_EQ(scores.connectivity, expected.connectivity);
  EXPECT_NEAR(*expected.links_per_chain, 4.0 / 3, 1e-9);
  EXPECT_EQ(expected.num_false_ends, 0);
}

TEST(StructureScores, OfAnEmptyReconstruction) {
  const StructureScores scores = Score(CurveSet(), Star({0, 90, 180}));
  EXPECT_FALSE(scores.links_per_chain.has_value());
  EXPECT_EQ(scores.num_chains, 3);
  EXPECT_EQ(scores.num_drawn_chains, 0);
  EXPECT_EQ(scores.num_free_ends, 0);
  EXPECT_EQ(scores.num_false_ends, 0);
  EXPECT_EQ(scores.num_false_junctions, 0);
  EXPECT_FALSE(scores.right_degrees.has_value());
  EXPECT_FALSE(scores.connectivity.has_value());
}

TEST(StructureScores, OfPointsAreAbsent) {
  CurveSet points;
  points.points = {{0, 0, 0}, {0.5, 0, 0}};
  const StructureScores scores = Score(points, Star({0, 90, 180}));
  EXPECT_FALSE(scores.links_per_chain.has_value());
  EXPECT_FALSE(scores.num_free_ends.has_value());
  EXPECT_FALSE(scores.num_false_junctions.has_value());
}

TEST(StructureScores, AgainstTruePointsOnlyCountEnds) {
  CurveSet points;
  points.points = {{0, 0, 0}, {0.5, 0, 0}};
  const StructureScores scores = Score(Star({0, 90, 180}), points);
  EXPECT_EQ(scores.num_free_ends, 3);
  EXPECT_FALSE(scores.num_false_ends.has_value());
  EXPECT_FALSE(scores.num_false_junctions.has_value());
  EXPECT_FALSE(scores.links_per_chain.has_value());
}

TEST(Intervals, BelongToTheSharesOfCurves) {
  EvaluationOptions options;
  options.taus = {kStructureTau};
  const CurveSet truth = Curves({Line(0, 1), Line(0, 1, 1), Line(0, 1, 2)});
  const TauResult row =
      EvaluateCurves(Curves({Line(0, 1), Line(0, 1, 5)}), truth, options).rows.at(0);
  // Of two curves, one right: a resample has none, one or two of them.
  ASSERT_TRUE(row.precision_interval.has_value());
  EXPECT_EQ(row.precision_interval->low, 0);
  EXPECT_EQ(row.precision_interval->high, 1);
  ASSERT_TRUE(row.recall_interval.has_value());
  EXPECT_LE(row.recall_interval->low, *row.recall);
  EXPECT_GE(row.recall_interval->high, *row.recall);
  EXPECT_TRUE(row.f_interval.has_value());
  CurveSet points;
  points.points = {{0, 0, 0}, {0.5, 0, 0}};
  const TauResult of_points = EvaluateCurves(points, points, options).rows.at(0);
  EXPECT_FALSE(of_points.precision_interval.has_value());
  EXPECT_FALSE(of_points.recall_interval.has_value());
  EXPECT_FALSE(of_points.f_interval.has_value());
}

}  // namespace
}  // namespace limn
