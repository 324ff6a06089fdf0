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

// Cubic B-spline over [knots[3], knots[n]], n control points, n + 4 knots that never descend; the
// first four are equal, and the last four, so that it begins and ends at its first and last control
// points.
struct CubicBSpline {
  std::vector<double> knots;
  std::vector<Eigen::Vector3d> control_points;
};

using CurveShape = std::variant<LineSegment, CircularArc, CubicBSpline>;

// "line", "arc", "circle" or "spline".
const char* ShapeName(const CurveShape& shape);

// What is wrong with it in words, empty if nothing: numbers that are not finite, a line without
// length, axes that are no unit vectors at a right angle, a radius or sweep out of range, knots
// that descend, are not clamped, do not fit the control points or leave a jump.
std::string ValidateShape(const CurveShape& shape);

Eigen::Vector3d PointAt(const CurveShape& shape, double t);
// With respect to t.
Eigen::Vector3d DerivativeAt(const CurveShape& shape, double t);

// The four basis functions that are not zero at t, and the index of the first of them.
struct SplineBasis {
  int first = 0;
  double value[4] = {};
};
SplineBasis BasisAt(const std::vector<double>& knots, double t);

// Points from start to end; the polyline stays within `tolerance` > 0 of the shape. A circle
// returns to its start.
Polyline3d SampleShape(const CurveShape& shape, double tolerance);

// Numbers that a file holds of it: 6 of a line, 11 of an arc, knots and control points of a spline.
size_t NumNumbers(const CurveShape& shape);

// The same shape moved: x -> scale * rotation * x + translation; scale > 0.
CurveShape Transformed(const CurveShape& shape, double scale, const Eigen::Matrix3d& rotation,
                       const Eigen::Vector3d& translation);

}  // namespace limn
