// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/shape.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "limn/geometry/bezier.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Longer arcs are drawn in parts: near half a turn their center would depend on the rounding of
// their ends.
constexpr double kMaxTurn = 2 * M_PI / 3;

void Append(const SvgSheet& sheet, const LineSegment& line, double t0, double t1, double,
            SvgPath* path) {
  path->MoveTo(sheet.ToSheet(PointAt(line, t0)));
  path->LineTo(sheet.ToSheet(PointAt(line, t1)));
}

void Append(const SvgSheet& sheet, const CubicBSpline& spline, double t0, double t1, double,
            SvgPath* path) {
  bool is_first = true;
  for (const CubicBezier3d& piece : BezierPieces(spline, t0, t1)) {
    if (is_first) path->MoveTo(sheet.ToSheet(piece[0]));
    path->CubicTo(sheet.ToSheet(piece[1]), sheet.ToSheet(piece[2]), sheet.ToSheet(piece[3]));
    is_first = false;
  }
}

void Append(const SvgSheet& sheet, const CircularArc& arc, double t0, double t1, double tolerance,
            SvgPath* path) {
  // The circle's two axes as seen: conjugate radii of an ellipse, whose own axes are the singular
  // vectors.
  Eigen::Matrix2d seen;
  seen << sheet.axes.topRows<2>() * arc.x_axis, sheet.axes.topRows<2>() * arc.y_axis;
  seen *= arc.radius;
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(seen, Eigen::ComputeFullU);
  const Eigen::Vector2d radii = svd.singularValues();
  if (2 * radii[1] < tolerance) {
    std::vector<Eigen::Vector2d> points;
    constexpr int kSteps = 256;
    for (int k = 0; k <= kSteps; ++k) {
      points.push_back(sheet.ToSheet(PointAt(arc, t0 + (t1 - t0) * k / kSteps)));
    }
    return AppendFitted(points, tolerance, path);
  }
  const Eigen::Vector2d major = svd.matrixU().col(0);
  const double rotation_deg = Degrees(std::atan2(major.y(), major.x()));
  const double turn = (t1 - t0) * arc.sweep_rad;
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / kMaxTurn - 1e-9)));
  path->MoveTo(sheet.ToSheet(PointAt(arc, t0)));
  for (int k = 1; k <= parts; ++k) {
    const Eigen::Vector3d end = PointAt(arc, k == parts ? t1 : t0 + (t1 - t0) * k / parts);
    path->ArcTo(radii, rotation_deg, seen.determinant() > 0, sheet.ToSheet(end));
  }
}

}  // namespace

void AppendFitted(const std::vector<Eigen::Vector2d>& points, double tolerance, SvgPath* path) {
  path->MoveTo(points.front());
  const std::vector<FittedPiece> pieces = FitBeziers(points, tolerance);
  if (pieces.empty()) path->LineTo(points.front());
  for (const FittedPiece& piece : pieces) {
    if (piece.is_straight) {
      path->LineTo(piece.control[3]);
    } else {
      path->CubicTo(piece.control[1], piece.control[2], piece.control[3]);
    }
  }
}

void AppendShape(const SvgSheet& sheet, const CurveShape& shape, double t0, double t1,
                 double tolerance, SvgPath* path) {
  std::visit([&](const auto& s) { Append(sheet, s, t0, t1, tolerance, path); }, shape);
}

}  // namespace limn
