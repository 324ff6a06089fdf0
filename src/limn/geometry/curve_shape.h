// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"

namespace limn {

// Parametric curves in space. A shape runs from t = 0 to t = 1.

struct LineSegment {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
};

// Starts at center + radius * x_axis and turns towards y_axis; both are unit vectors and
// orthogonal. A sweep of 2 pi is a circle.
struct CircularArc {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();
  double radius = 1;
  double sweep_rad = 0;  // in (0, 2 pi]

  Eigen::Vector3d Normal() const { return x_axis.cross(y_axis); }
  bool IsCircle() const;
};

// Clamped cubic B-spline over [knots[3], knots[n]]: n control points, n + 4 nondecreasing knots, of
// which the first four and the last four are equal.
struct CubicBSpline {
  std::vector<double> knots;
  std::vector<Eigen::Vector3d> control_points;
};

using CurveShape = std::variant<LineSegment, CircularArc, CubicBSpline>;

// "line", "arc", "circle" or "spline".
const char* ShapeName(const CurveShape& shape);

// Describes what is wrong with a shape; empty if it is valid: non-finite numbers, a line without
// length, axes that are not orthonormal, a radius or sweep out of range, knots that decrease, are
// not clamped, have the wrong number or allow a jump.
std::string ValidateShape(const CurveShape& shape);

// Of a point, or of its projection to the plane of an arc, from x_axis to y_axis, in (-pi, pi].
double AngleOn(const CircularArc& arc, const Eigen::Vector3d& point);
// From the whole circle.
double DistanceFromCircle(const CircularArc& arc, const Eigen::Vector3d& point);

Eigen::Vector3d PointAt(const CurveShape& shape, double t);
// With respect to t.
Eigen::Vector3d DerivativeAt(const CurveShape& shape, double t);

// The four basis functions that are nonzero at t, and the index of the first.
struct SplineBasis {
  int first = 0;
  double value[4] = {};
};
SplineBasis BasisAt(const std::vector<double>& knots, double t);

// Points from start to end whose polyline is within `tolerance` > 0 of the shape. A circle returns
// to its start.
Polyline3d SampleShape(const CurveShape& shape, double tolerance);

// Number of values that describe it in a file: 6 for a line, 11 for an arc, knots and control
// points for a spline.
size_t NumNumbers(const CurveShape& shape);

// The shape under x -> scale * rotation * x + translation, scale > 0.
CurveShape Transformed(const CurveShape& shape, double scale, const Eigen::Matrix3d& rotation,
                       const Eigen::Vector3d& translation);

}  // namespace limn
