// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/bezier.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

template <typename Point>
Point At(const std::array<Point, 4>& c, double t) {
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

CubicBSpline BentSpline() {
  CubicBSpline spline;
  spline.knots = {2, 2, 2, 2, 3, 3, 4.5, 7, 7, 7, 7};
  for (int i = 0; i < 7; ++i) spline.control_points.emplace_back(i, i * i % 5, std::sin(i));
  return spline;
}

TEST(BezierPieces, AreTheSplineExactly) {
  const CubicBSpline spline = BentSpline();
  ASSERT_EQ(ValidateShape(spline), "");
  const std::vector<CubicBezier3d> pieces = BezierPieces(spline);
  const double knots[] = {2, 3, 4.5, 7};
  ASSERT_EQ(pieces.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    for (const double t : {0.0, 0.3, 0.8, 1.0}) {
      const double u = knots[k] + t * (knots[k + 1] - knots[k]);
      EXPECT_LT((At(pieces[k], t) - PointAt(spline, (u - 2) / 5)).norm(), 1e-12);
    }
  }
}

TEST(BezierPieces, OfAPart) {
  const CubicBSpline spline = BentSpline();
  const std::vector<CubicBezier3d> pieces = BezierPieces(spline, 0.1, 0.4);
  ASSERT_EQ(pieces.size(), 2u);  // cut by the knot at 3, t = 0.2
  EXPECT_LT((At(pieces[0], 0.5) - PointAt(spline, 0.15)).norm(), 1e-12);
  EXPECT_LT((At(pieces[1], 0.25) - PointAt(spline, 0.25)).norm(), 1e-12);
  EXPECT_LT((pieces[1][3] - PointAt(spline, 0.4)).norm(), 1e-12);
}

using Points = std::vector<Eigen::Vector2d>;

double Distance(const Points& line, const Eigen::Vector2d& point) {
  double nearest = 1e300;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Eigen::Vector2d along = line[i + 1] - line[i];
    const double t =
        std::clamp((point - line[i]).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, (line[i] + t * along - point).norm());
  }
  return nearest;
}

Points Flattened(const std::vector<FittedPiece>& pieces) {
  Points points;
  for (const FittedPiece& piece : pieces) {
    for (int k = 0; k <= 200; ++k) points.push_back(At(piece.control, k / 200.0));
  }
  return points;
}

void ExpectNear(const std::vector<FittedPiece>& pieces, const Points& line, double tolerance) {
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().control[0], line.front());
  EXPECT_EQ(pieces.back().control[3], line.back());
  const Points drawn = Flattened(pieces);
  double largest = 0;
  for (const Eigen::Vector2d& point : drawn) largest = std::max(largest, Distance(line, point));
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    for (const double t : {0.0, 0.37, 0.71, 1.0}) {
      largest = std::max(largest, Distance(drawn, (1 - t) * line[i] + t * line[i + 1]));
    }
  }
  // Between the points that are looked at, a tenth more at most.
  EXPECT_LE(largest, 1.1 * tolerance);
  for (size_t k = 0; k + 1 < pieces.size(); ++k) {
    EXPECT_EQ(pieces[k].control[3], pieces[k + 1].control[0]);
  }
}

Points Circle(double radius, int count) {
  Points points;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2 * M_PI * (k % count) / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TEST(FitBeziers, ACircleNeedsFewPiecesAndIsSmooth) {
  const Points line = Circle(100, 200);
  const std::vector<FittedPiece> pieces = FitBeziers(line, 0.1);
  ExpectNear(pieces, line, 0.1);
  // A quarter of a circle is off by 0.03 % of its radius; an eighth far less.
  EXPECT_LE(pieces.size(), 10u);
  for (size_t k = 0; k < pieces.size(); ++k) {
    const auto& in = pieces[k].control;
    const auto& out = pieces[(k + 1) % pieces.size()].control;
    const double cosine = (in[3] - in[2]).normalized().dot((out[1] - out[0]).normalized());
    EXPECT_GT(cosine, 0.9999) << k;
  }
}

TEST(FitBeziers, StraightRunsAreLinesAndCornersStay) {
  const Points line = {{0, 0}, {10, 0.01}, {30, 0}, {30, 20}, {29.99, 50}};
  const std::vector<FittedPiece> pieces = FitBeziers(line, 0.1);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(pieces[0].is_straight);
  EXPECT_TRUE(pieces[1].is_straight);
  EXPECT_EQ(pieces[0].control[3], Eigen::Vector2d(30, 0));
}

TEST(FitBeziers, RandomLinesStayWithinTheTolerance) {
  std::mt19937 random(7);
  testing::NormalDistribution<double> turn(0, 0.4);
  for (int round = 0; round < 200; ++round) {
    Points line = {{0, 0}};
    double angle = 0;
    for (int k = 0; k < 40; ++k) {
      angle += turn(random);
      line.push_back(line.back() + 5 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    SCOPED_TRACE(round);
    ExpectNear(FitBeziers(line, 0.1), line, 0.1);
  }
}

TEST(FitBeziers, WaysBackAndPointsWithoutLength) {
  EXPECT_TRUE(FitBeziers(Points{}, 0.1).empty());
  EXPECT_TRUE(FitBeziers(Points{{1, 1}, {1, 1}}, 0.1).empty());
  const Points there_and_back = {{0, 0}, {10, 0}, {0, 0}};
  ExpectNear(FitBeziers(there_and_back, 0.1), there_and_back, 0.1);
}

}  // namespace
}  // namespace limn
