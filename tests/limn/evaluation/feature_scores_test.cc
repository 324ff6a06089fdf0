// SPDX-License-Identifier: BSD-3-Clause
// How single features of the truth are drawn: scores of hand-made sets.
#include "limn/evaluation/feature_scores.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "limn/evaluation/plain_curves.h"
#include "limn/model/view.h"
#include "limn/util/angles.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::Curves;
using testing::Line;

// At depth 1, where all is that is judged in footprints here.
constexpr double kFootprint = 0.01;

Eigen::Vector3d At(double angle_deg, double radius) {
  return {radius * std::cos(angle_deg * kDeg), radius * std::sin(angle_deg * kDeg), 0};
}

// Around the origin, with a vertex every `step` degrees. Whole turns are closed.
Polyline3d Arc(double from_deg, double to_deg, double radius, double step = 5) {
  Polyline3d arc;
  for (double angle = from_deg; angle <= to_deg; angle += step) arc.push_back(At(angle, radius));
  if (to_deg - from_deg == 360) arc.back() = arc.front();
  return arc;
}

// With an end `gap` before the origin.
Polyline3d Arm(double angle_deg, double gap) { return {At(angle_deg, gap), At(angle_deg, 1)}; }

FeatureScores ScoreInWorld(const CurveSet& drawn, const CurveSet& truth, double tau) {
  EvaluationOptions options;
  options.taus = {tau};
  return EvaluateCurves(drawn, truth, options).rows.at(0).features;
}

FeatureScores Score(CurveSet drawn, CurveSet truth, double tau = 1,
                    EvaluationOptions options = {}) {
  for (CurveSet* set : {&drawn, &truth}) {
    for (Polyline3d& polyline : set->polylines) {
      for (Eigen::Vector3d& point : polyline) point.z() += 1;
    }
    for (CurveNode& node : set->nodes) node.position_in_world.z() += 1;
  }
  options.taus = {tau};
  return EvaluateCurvesInFootprints(drawn, truth, {testing::ForwardView()}, options)
      .rows.at(0)
      .features;
}

// Of the only bin that there is.
CircleScores ScoreCircle(const CurveSet& drawn, const CurveSet& truth) {
  const FeatureScores scores = Score(drawn, truth);
  EXPECT_EQ(scores.circles.size(), 1u);
  return scores.circles.empty() ? CircleScores() : scores.circles[0];
}

const CurveSet kCircle = Curves({Arc(0, 360, 5 * kFootprint)});

TEST(Circles, DrawnWhole) {
  CurveSet drawn = kCircle;
  const CircleScores untyped = ScoreCircle(drawn, kCircle);
  EXPECT_EQ(untyped.from, 4);
  EXPECT_EQ(untyped.to, 6);
  EXPECT_EQ(untyped.num_circles, 1);
  EXPECT_EQ(untyped.covered, 1);
  EXPECT_EQ(untyped.num_one_curve, 1);
  EXPECT_EQ(untyped.num_closed, 1);
  EXPECT_FALSE(untyped.num_of_type_circle.has_value());
  drawn.is_circle = {0};
  EXPECT_EQ(ScoreCircle(drawn, kCircle).num_of_type_circle, 0);
  drawn.is_circle = {1};
  EXPECT_EQ(ScoreCircle(drawn, kCircle).num_of_type_circle, 1);
}

TEST(Circles, DrawnAsTwoHalves) {
  CurveSet drawn = Curves({Arc(0, 180, 5 * kFootprint), Arc(180, 360, 5 * kFootprint)});
  drawn.is_circle = {0, 0};
  const CircleScores halves = ScoreCircle(drawn, kCircle);
  EXPECT_EQ(halves.covered, 1);
  EXPECT_EQ(halves.num_one_curve, 0);
  EXPECT_EQ(halves.num_closed, 0);
  EXPECT_EQ(halves.num_of_type_circle, 0);
  drawn.curves = {0, 0};
  EXPECT_EQ(ScoreCircle(drawn, kCircle).num_one_curve, 1);
  EXPECT_EQ(ScoreCircle(drawn, kCircle).num_closed, 0);
}

TEST(Circles, DrawnInPart) {
  // A footprint is 11 degrees: samples beside the ends are covered, too.
  const CircleScores most = ScoreCircle(Curves({Arc(0, 340, 5 * kFootprint)}), kCircle);
  EXPECT_EQ(most.covered, 1);
  EXPECT_EQ(most.num_one_curve, 1);
  EXPECT_EQ(most.num_closed, 0);
  const CircleScores half = ScoreCircle(Curves({Arc(0, 180, 5 * kFootprint)}), kCircle);
  EXPECT_NEAR(half.covered, (180 + 2 * 11.5) / 360, 0.02);
  EXPECT_EQ(half.num_one_curve, 0);
}

TEST(Circles, NotCoveredByWhatIsFarOrCrosses) {
  EXPECT_EQ(ScoreCircle(Curves({Arc(0, 360, 6.5 * kFootprint)}), kCircle).covered, 0);
  CurveSet spokes;
  for (int angle = 0; angle < 360; angle += 10) {
    spokes.polylines.push_back({At(angle, 4 * kFootprint), At(angle, 6 * kFootprint)});
  }
  EXPECT_EQ(ScoreCircle(spokes, kCircle).covered, 0);
  EXPECT_EQ(ScoreCircle(CurveSet(), kCircle).covered, 0);
}

TEST(Circles, ByRadius) {
  CurveSet truth;
  for (const double radius : {3.0, 11.0, 14.0, 40.0}) {
    truth.polylines.push_back(Arc(0, 360, radius * kFootprint));
  }
  const CurveSet drawn = Curves({truth.polylines[1]});
  const std::vector<CircleScores> bins = Score(drawn, truth).circles;
  ASSERT_EQ(bins.size(), 3u);
  EXPECT_EQ(bins[0].to, 4);
  EXPECT_EQ(bins[1].from, 10);
  EXPECT_EQ(bins[1].num_circles, 2);
  EXPECT_EQ(bins[1].num_closed, 1);
  EXPECT_EQ(bins[2].from, 30);
  EXPECT_TRUE(std::isinf(bins[2].to));
  const std::vector<CircleScores> in_world = ScoreInWorld(drawn, truth, kFootprint).circles;
  ASSERT_EQ(in_world.size(), 1u);
  EXPECT_EQ(in_world[0].num_circles, 4);
}

TEST(Circles, OtherClosedCurvesAreNone) {
  Polyline3d ellipse, saddle, open = Arc(0, 360, 0.1);
  for (const Eigen::Vector3d& point : Arc(0, 360, 0.1)) {
    ellipse.emplace_back(point.x(), 0.97 * point.y(), 0);
    saddle.emplace_back(point.x(), point.y(), 20 * point.x() * point.y());
  }
  open.pop_back();
  EXPECT_TRUE(
      Score(CurveSet(), Curves({ellipse, saddle, open, Arc(0, 360, 0.1, 45)})).circles.empty());
  EXPECT_EQ(Score(CurveSet(), Curves({Arc(0, 360, 0.1, 30)})).circles.size(), 1u);
}

TEST(Circles, PartlyOutsideTheRegionDoNotCount) {
  EvaluationOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(-0.06, -1, 0), Eigen::Vector3d(0.04, 1, 2));
  EXPECT_TRUE(Score(kCircle, kCircle, 1, options).circles.empty());
  options.region->max().x() = 0.06;
  EXPECT_EQ(Score(kCircle, kCircle, 1, options).circles.size(), 1u);
}

// Lines along x and y through the origin, which is a junction of this kind.
CurveSet Cross(JunctionKind kind) {
  return Curves({Line(-1, 1), {{0, -1, 0}, {0, 1, 0}}}, {{Eigen::Vector3d::Zero(), 4, kind}});
}

CurveSet Arms(const std::vector<double>& angles_deg, double gap = 0) {
  CurveSet arms;
  for (const double angle : angles_deg) arms.polylines.push_back(Arm(angle, gap));
  return arms;
}

TEST(JunctionKinds, CrossingWithOneNodeOrTwo) {
  const CurveSet truth = Cross(JunctionKind::kCrossing);
  const FeatureScores one = Score(Arms({0, 90, 180, 270}), truth);
  EXPECT_EQ(one.crossings.num_junctions, 1);
  EXPECT_EQ(one.crossings.num_found, 1);
  EXPECT_EQ(one.crossings.num_with_4, 1);
  EXPECT_EQ(one.tees.num_junctions, 0);
  EXPECT_EQ(one.corners.num_junctions, 0);
  const Eigen::Vector3d left(-0.005, 0, 0), right(0.005, 0, 0);
  const CurveSet two = Curves({{At(180, 1), left},
                               {left, right},
                               {right, At(0, 1)},
                               {left, At(90, 1)},
                               {right, At(270, 1)}});
  EXPECT_EQ(Score(two, truth).crossings.num_found, 1);
  EXPECT_EQ(Score(two, truth).crossings.num_with_4, 0);
  EXPECT_EQ(Score(Curves(truth.polylines), truth).crossings.num_found, 0);
}

TEST(JunctionKinds, NodesMustBeWithinJunctionTaus) {
  CurveSet truth = Cross(JunctionKind::kCrossing);
  const CurveSet drawn = Arms({0, 90, 180, 270});
  truth.nodes[0].position_in_world.x() = 1.9 * kFootprint;
  EXPECT_EQ(Score(drawn, truth).crossings.num_with_4, 1);
  truth.nodes[0].position_in_world.x() = 2.1 * kFootprint;
  EXPECT_EQ(Score(drawn, truth).crossings.num_junctions, 1);
  EXPECT_EQ(Score(drawn, truth).crossings.num_with_4, 0);
}

TEST(JunctionKinds, TeesAndCornersNeedThreeEndsExceptOfTwoCurves) {
  CurveSet truth = Arms({0, 90, 180});
  truth.nodes = {{Eigen::Vector3d::Zero(), 3, JunctionKind::kTee}};
  EXPECT_EQ(Score(Arms({0, 90, 180}), truth).tees.num_found, 1);
  EXPECT_EQ(Score(Arms({0, 90}), truth).tees.num_found, 0);
  truth.nodes[0].kind = JunctionKind::kCorner;
  EXPECT_EQ(Score(Arms({0, 90}), truth).corners.num_junctions, 1);
  EXPECT_EQ(Score(Arms({0, 90}), truth).corners.num_found, 0);
  truth.nodes[0].degree = 2;
  EXPECT_EQ(Score(Arms({0, 90}), truth).corners.num_found, 1);
}

// Lines this far apart. Powers of two, so that what is in the middle is so exactly.
constexpr double kApart = 0.03125;
const CurveSet kPair = Curves({Line(0, 1), Line(0, 1, kApart)});

TEST(Pairs, DrawnAsTwoOrAsOneOfThem) {
  const std::vector<PairScores> both = Score(kPair, kPair).pairs;
  ASSERT_EQ(both.size(), 3u);
  EXPECT_EQ(both[0].true_length, 0);
  EXPECT_FALSE(both[0].recall.has_value());
  EXPECT_EQ(both[1].from, 2.5);
  EXPECT_EQ(both[1].to, 4);
  EXPECT_NEAR(both[1].true_length, 2, 1e-9);
  EXPECT_EQ(both[1].recall, 1);
  EXPECT_EQ(both[2].true_length, 0);
  EXPECT_NEAR(*Score(Curves({Line(0, 1)}), kPair).pairs[1].recall, 0.5, 1e-9);
  EXPECT_EQ(Score(CurveSet(), kPair).pairs[1].recall, 0);
}

TEST(Pairs, DrawnAsOneBetweenThem) {
  // Within a tau of 2 of both.
  EXPECT_EQ(Score(Curves({Line(0, 1, kApart / 2)}), kPair, 2).pairs[1].recall, 0);
  EXPECT_NEAR(*Score(Curves({Line(0, 1, kApart * 0.49)}), kPair, 2).pairs[1].recall, 0.5, 1e-9);
  // A tau of 4 also finds one in place of the other.
  EXPECT_NEAR(*Score(Curves({Line(0, 1)}), kPair, 4).pairs[1].recall, 0.5, 1e-9);
}

TEST(Pairs, AreOfTrueCurvesAlongsideAtThatDistance) {
  const auto length_with = [](const Polyline3d& other) {
    const CurveSet truth = Curves({Line(0, 1), other});
    double length = 0;
    for (const PairScores& bin : Score(truth, truth).pairs) length += bin.true_length;
    return length;
  };
  EXPECT_NEAR(length_with(Line(0, 0.5, 3 * kFootprint)), 1, 0.02);
  EXPECT_EQ(length_with(Line(0, 1, 1.9 * kFootprint)), 0);
  EXPECT_EQ(length_with(Line(0, 1, 5.1 * kFootprint)), 0);
  EXPECT_EQ(length_with(Line(1.03, 2)), 0);                      // ahead
  EXPECT_EQ(length_with({{0.5, 0.025, 0}, {0.5, 0.05, 0}}), 0);  // across
  EXPECT_TRUE(ScoreInWorld(kPair, kPair, kFootprint).pairs.empty());
}

TEST(Pairs, CurvesAcrossOneAreNotTakenForIt) {
  CurveSet drawn = kPair;
  for (int i = 0; i < 100; ++i) {
    drawn.polylines.push_back({{0.01 * i, 0.001, 0}, {0.01 * i, kApart - 0.001, 0}});
  }
  EXPECT_EQ(Score(drawn, kPair).pairs[1].recall, 1);
}

// Two arms from the origin, which is a corner.
CurveSet Corner() {
  CurveSet corner = Arms({0, 90});
  corner.nodes = {{Eigen::Vector3d::Zero(), 2, JunctionKind::kCorner}};
  return corner;
}

TEST(DrawnCorners, AreOpenByAGap) {
  const CornerScores joined = Score(Arms({0, 90}), Corner()).drawn_corners;
  EXPECT_EQ(joined.num_drawn, 1);
  EXPECT_EQ(joined.num_open, 0);
  EXPECT_EQ(joined.num_meetings, 1);
  EXPECT_EQ(joined.num_open_meetings, 0);
  EXPECT_EQ(joined.num_open_near, 0);
  const CornerScores open = Score(Arms({0, 90}, 0.5 * kFootprint), Corner()).drawn_corners;
  EXPECT_EQ(open.num_drawn, 1);
  EXPECT_EQ(open.num_open, 1);
  EXPECT_EQ(open.num_open_meetings, 1);
  EXPECT_EQ(open.num_open_near, 1);
  EXPECT_EQ(Score(Arms({0}), Corner()).drawn_corners.num_drawn, 0);
}

TEST(DrawnCorners, EndsAreNearWithinThreeFootprints) {
  // At a tau of 2 arms are drawn if half of 8 footprints are.
  const CornerScores far = Score(Arms({0, 90}, 3.5 * kFootprint), Corner(), 2).drawn_corners;
  EXPECT_EQ(far.num_open_meetings, 1);
  EXPECT_EQ(far.num_open_near, 0);
  EXPECT_EQ(Score(Arms({0, 90}, 2.5 * kFootprint), Corner(), 2).drawn_corners.num_open_near, 1);
  const CornerScores in_world =
      ScoreInWorld(Arms({0, 90}, 0.5 * kFootprint), Corner(), kFootprint).drawn_corners;
  EXPECT_EQ(in_world.num_open, 1);
  EXPECT_FALSE(in_world.num_open_near.has_value());
}

TEST(DrawnCorners, AreAllMeetingsIfTheTruthHasNoKinds) {
  CurveSet truth = Arms({0, 90, 180});
  CurveSet drawn = Curves({Line(-1, 1), Arm(90, 0.5 * kFootprint)});
  const CornerScores corners = Score(drawn, truth).drawn_corners;
  EXPECT_EQ(corners.num_drawn, 1);
  EXPECT_EQ(corners.num_open, 1);
  EXPECT_EQ(corners.num_meetings, 3);
  EXPECT_EQ(corners.num_open_meetings, 2);
  truth.nodes = {{Eigen::Vector3d::Zero(), 3, JunctionKind::kTee}};
  EXPECT_EQ(Score(drawn, truth).drawn_corners.num_drawn, 0);
}

}  // namespace
}  // namespace limn
