// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"

namespace limn {

// Control points of a cubic Bezier curve.
using CubicBezier3d = std::array<Eigen::Vector3d, 4>;
using CubicBezier2d = std::array<Eigen::Vector2d, 4>;

// The part of a spline between 0 <= t0 < t1 <= 1 as cubic Bezier curves end to end, exactly: one
// per knot interval that it overlaps.
std::vector<CubicBezier3d> BezierPieces(const CubicBSpline& spline, double t0 = 0, double t1 = 1);

// A piece of a fitted curve: a straight line from the first to the last control point, or a curve.
struct FittedPiece {
  CubicBezier2d control;
  bool is_straight = false;
};

// Fits lines and cubic Bezier curves, end to end, to a polyline in the plane: each is within
// `tolerance` > 0 of the other. They meet smoothly except at corners of the polyline (30 degrees or
// more). A polyline that returns to its first point is treated as smooth there. Empty for a
// polyline without length. Time: points and length over tolerance, times the number of pieces.
std::vector<FittedPiece> FitBeziers(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace limn
