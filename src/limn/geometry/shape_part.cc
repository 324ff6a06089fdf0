// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/shape_part.h"

#include <cmath>

#include "limn/geometry/bezier.h"

namespace limn {
namespace {

CurveShape Part(const LineSegment& line, double t0, double t1) {
  return LineSegment{PointAt(line, t0), PointAt(line, t1)};
}

CurveShape Part(const CircularArc& arc, double t0, double t1) {
  const double turn = t0 * arc.sweep_rad;
  CircularArc part = arc;
  part.x_axis = (std::cos(turn) * arc.x_axis + std::sin(turn) * arc.y_axis).normalized();
  part.y_axis = std::cos(turn) * arc.y_axis - std::sin(turn) * arc.x_axis;
  part.y_axis = (part.y_axis - part.y_axis.dot(part.x_axis) * part.x_axis).normalized();
  part.sweep_rad = (t1 - t0) * arc.sweep_rad;
  return part;
}

CurveShape Part(const CubicBSpline& spline, double t0, double t1) {
  const std::vector<CubicBezier3d> pieces = BezierPieces(spline, t0, t1);
  CubicBSpline part;
  part.control_points = {pieces.front()[0]};
  part.knots = {0};
  for (size_t i = 0; i < pieces.size(); ++i) {
    part.control_points.insert(part.control_points.end(), pieces[i].begin() + 1, pieces[i].end());
    part.knots.insert(part.knots.end(), 3, static_cast<double>(i));
  }
  part.knots.insert(part.knots.end(), 4, static_cast<double>(pieces.size()));
  return part;
}

}  // namespace

CurveShape PartOf(const CurveShape& shape, double t0, double t1) {
  if (t0 == 0 && t1 == 1) return shape;
  return std::visit([&](const auto& s) { return Part(s, t0, t1); }, shape);
}

}  // namespace limn
