// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/curve_shape.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

CircularArc SomeArc(double sweep_rad) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  return {{1, 2, 3}, turn.col(0), turn.col(1), 2, sweep_rad};
}

CubicBSpline SomeSpline() {
  return {{1, 1, 1, 1, 2, 4, 5, 5, 5, 5},
          {{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {3, 1, -1}, {4, 0, 0}, {5, 2, 1}}};
}

const std::vector<CurveShape>& AllShapes() {
  static const std::vector<CurveShape> shapes = {LineSegment{{1, 2, 3}, {-1, 0, 5}}, SomeArc(1.2),
                                                 SomeArc(2 * M_PI), SomeSpline()};
  return shapes;
}

TEST(CurveShape, DerivativesAreThoseOfThePoints) {
  for (const CurveShape& shape : AllShapes()) {
    for (double t = 0.05; t < 1; t += 0.09) {
      constexpr double h = 1e-5;
      const Eigen::Vector3d numeric = (PointAt(shape, t + h) - PointAt(shape, t - h)) / (2 * h);
      EXPECT_LT((DerivativeAt(shape, t) - numeric).norm(), 1e-6) << ShapeName(shape) << " " << t;
    }
  }
}

TEST(CurveShape, SplineBeginsAndEndsAtItsControlPoints) {
  const CubicBSpline spline = SomeSpline();
  EXPECT_EQ(PointAt(spline, 0), spline.control_points.front());
  EXPECT_LT((PointAt(spline, 1) - spline.control_points.back()).norm(), 1e-15);
  // The tangents there are along the first and last leg.
  const Eigen::Vector3d leg = spline.control_points[1] - spline.control_points[0];
  EXPECT_LT(DerivativeAt(spline, 0).normalized().cross(leg.normalized()).norm(), 1e-12);
}

TEST(CurveShape, SplineOfEquallySpacedPointsOfALineIsTheLine) {
  // Greville's points: knots and control points in proportion.
  CubicBSpline spline = {{0, 0, 0, 0, 3, 3.5, 9, 9, 9, 9}, {}};
  for (int i = 0; i < 6; ++i) {
    const double mean = (spline.knots[i + 1] + spline.knots[i + 2] + spline.knots[i + 3]) / 3;
    spline.control_points.push_back(mean / 9 * Eigen::Vector3d(1, -2, 0.5));
  }
  for (double t = 0; t <= 1; t += 0.1) {
    EXPECT_LT((PointAt(spline, t) - t * Eigen::Vector3d(1, -2, 0.5)).norm(), 1e-12);
  }
}

TEST(CurveShape, BasisIsAPartitionOfOne) {
  const std::vector<double>& knots = SomeSpline().knots;
  for (double t = 0; t <= 1; t += 0.05) {
    const SplineBasis basis = BasisAt(knots, t);
    EXPECT_GE(basis.first, 0);
    EXPECT_LE(basis.first, 2);
    double sum = 0;
    for (const double value : basis.value) sum += value;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(CurveShape, SamplesStayNear) {
  constexpr double tolerance = 1e-3;
  for (const CurveShape& shape : AllShapes()) {
    const Polyline3d points = SampleShape(shape, tolerance);
    EXPECT_LT((points.front() - PointAt(shape, 0)).norm(), 1e-12);
    EXPECT_LT((points.back() - PointAt(shape, 1)).norm(), 1e-12);
    for (double t = 0; t <= 1; t += 0.003) {
      EXPECT_LT(std::sqrt(ClosestPoint(points, PointAt(shape, t)).squared_distance),
                1.05 * tolerance);
    }
    EXPECT_LT(points.size(), 400u);
  }
  const Polyline3d circle = SampleShape(SomeArc(2 * M_PI), tolerance);
  EXPECT_EQ(circle.front(), circle.back());
}

TEST(CurveShape, MovedAsItsPoints) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(-1.1, Eigen::Vector3d(0, 2, 1).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(5, -6, 7);
  for (const CurveShape& shape : AllShapes()) {
    const CurveShape moved = Transformed(shape, 3, turn, shift);
    for (double t = 0; t <= 1; t += 0.25) {
      const Eigen::Vector3d expected = 3 * (turn * PointAt(shape, t)) + shift;
      EXPECT_LT((PointAt(moved, t) - expected).norm(), 1e-12);
    }
  }
}

TEST(CurveShape, BrokenOnesAreTold) {
  for (const CurveShape& shape : AllShapes()) EXPECT_THAT(ValidateShape(shape), IsEmpty());
  EXPECT_THAT(ValidateShape(LineSegment{}), HasSubstr("no length"));
  CircularArc arc = SomeArc(1);
  arc.y_axis = arc.x_axis;
  EXPECT_THAT(ValidateShape(arc), HasSubstr("right angle"));
  EXPECT_THAT(ValidateShape(SomeArc(7)), HasSubstr("sweep"));
  CubicBSpline spline = SomeSpline();
  spline.knots.pop_back();
  EXPECT_THAT(ValidateShape(spline), HasSubstr("do not fit"));
  spline = SomeSpline();
  spline.knots[5] = 0.5;
  EXPECT_THAT(ValidateShape(spline), HasSubstr("do not ascend"));
  spline = SomeSpline();
  spline.knots[3] = 1.5;
  EXPECT_THAT(ValidateShape(spline), HasSubstr("not clamped"));
  spline.knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
  EXPECT_THAT(ValidateShape(spline), HasSubstr("too often"));
}

}  // namespace
}  // namespace limn
