// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/curve_shape.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace limn {
namespace {

constexpr int kOrder = 4;
constexpr double kFullTurn = 2 * M_PI;

template <typename... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <typename... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

// The knot interval [knots[i], knots[i + 1]) with t in it that is not empty; the last one at the
// end.
int SpanOf(const std::vector<double>& knots, double t) {
  const auto first = knots.begin() + kOrder - 1;
  const auto last = knots.end() - kOrder;  // the end of the range
  const auto above = std::upper_bound(first, last, t);
  auto span = above - 1;
  while (span > first && *span == *last) --span;
  return static_cast<int>(span - knots.begin());
}

double Range(const std::vector<double>& knots) { return knots.back() - knots.front(); }

double KnotAt(const std::vector<double>& knots, double t) {
  return knots.front() + std::clamp(t, 0.0, 1.0) * Range(knots);
}

Eigen::Vector3d ArcPoint(const CircularArc& arc, double angle) {
  return arc.center + arc.radius * (std::cos(angle) * arc.x_axis + std::sin(angle) * arc.y_axis);
}

// De Boor's recursion for the basis of the given order at u, in the span that holds it.
void BasisOfOrder(const std::vector<double>& knots, int span, double u, int order, double* value) {
  value[0] = 1;
  for (int k = 1; k < order; ++k) {
    double saved = 0;
    for (int j = 0; j < k; ++j) {
      const double right = knots[span + j + 1];
      const double left = knots[span + 1 + j - k];
      const double part = value[j] / (right - left);
      value[j] = saved + (right - u) * part;
      saved = (u - left) * part;
    }
    value[k] = saved;
  }
}

Eigen::Vector3d SplinePoint(const CubicBSpline& spline, double t) {
  const SplineBasis basis = BasisAt(spline.knots, t);
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int k = 0; k < kOrder; ++k) {
    point += basis.value[k] * spline.control_points[basis.first + k];
  }
  return point;
}

Eigen::Vector3d SplineDerivative(const CubicBSpline& spline, double t) {
  const double u = KnotAt(spline.knots, t);
  const int span = SpanOf(spline.knots, u);
  double value[kOrder];
  BasisOfOrder(spline.knots, span, u, kOrder - 1, value);
  Eigen::Vector3d derivative = Eigen::Vector3d::Zero();
  for (int k = 0; k < kOrder - 1; ++k) {
    const int i = span - (kOrder - 2) + k;  // difference of control points i and i - 1
    const double width = spline.knots[i + kOrder - 1] - spline.knots[i];
    derivative +=
        value[k] * (kOrder - 1) / width * (spline.control_points[i] - spline.control_points[i - 1]);
  }
  return derivative * Range(spline.knots);
}

// Halves [t0, t1] until chords are near enough; a chord is judged at its quarters.
void Refine(const CurveShape& shape, double t0, double t1, double tolerance, int depth,
            Polyline3d* points) {
  const Eigen::Vector3d start = points->back();
  const Eigen::Vector3d end = PointAt(shape, t1);
  bool is_near = true;
  for (const double part : {0.25, 0.5, 0.75}) {
    const Eigen::Vector3d at = PointAt(shape, t0 + part * (t1 - t0));
    const Polyline3d chord = {start, end};
    is_near &= ClosestPoint(chord, at).squared_distance <= tolerance * tolerance;
  }
  if (is_near || depth == 0) {
    points->push_back(end);
    return;
  }
  const double middle = 0.5 * (t0 + t1);
  Refine(shape, t0, middle, tolerance, depth - 1, points);
  Refine(shape, middle, t1, tolerance, depth - 1, points);
}

Polyline3d SampleSpline(const CubicBSpline& spline, double tolerance) {
  constexpr int kMaxHalvings = 16;
  Polyline3d points = {spline.control_points.front()};
  const CurveShape shape = spline;
  double t0 = 0;
  for (size_t k = kOrder; k + kOrder <= spline.knots.size(); ++k) {
    const double t1 = (spline.knots[k] - spline.knots.front()) / Range(spline.knots);
    if (!(t1 > t0)) continue;
    Refine(shape, t0, t1, tolerance, kMaxHalvings, &points);
    t0 = t1;
  }
  return points;
}

Polyline3d SampleArc(const CircularArc& arc, double tolerance) {
  const double step =
      2 * std::acos(std::clamp(1 - tolerance / arc.radius, std::cos(M_PI / 8), 1 - 1e-12));
  const int count = std::max(1, static_cast<int>(std::ceil(arc.sweep_rad / step)));
  Polyline3d points;
  for (int k = 0; k <= count; ++k) points.push_back(ArcPoint(arc, arc.sweep_rad * k / count));
  if (arc.IsCircle()) points.back() = points.front();
  return points;
}

std::string Broken(const LineSegment& line) {
  if (!line.start.allFinite() || !line.end.allFinite()) return "a number is not finite";
  return line.start == line.end ? "the line has no length" : "";
}

std::string Broken(const CircularArc& arc) {
  constexpr double kTolerance = 1e-6;
  if (!arc.center.allFinite() || !arc.x_axis.allFinite() || !arc.y_axis.allFinite() ||
      !std::isfinite(arc.radius)) {
    return "a number is not finite";
  }
  if (!(arc.radius > 0)) return "the radius is not positive";
  if (!(arc.sweep_rad > 0 && arc.sweep_rad <= kFullTurn * (1 + kTolerance))) {
    return "the sweep is not within a turn";
  }
  const bool orthonormal = std::abs(arc.x_axis.norm() - 1) < kTolerance &&
                           std::abs(arc.y_axis.norm() - 1) < kTolerance &&
                           std::abs(arc.x_axis.dot(arc.y_axis)) < kTolerance;
  return orthonormal ? "" : "the axes are not unit vectors at a right angle";
}

std::string Broken(const CubicBSpline& spline) {
  const std::vector<double>& knots = spline.knots;
  const auto is_finite = [](double knot) { return std::isfinite(knot); };
  const size_t count = spline.control_points.size();
  if (count < kOrder || knots.size() != count + kOrder) {
    return "knots and control points do not fit";
  }
  if (!std::all_of(knots.begin(), knots.end(), is_finite) ||
      !std::all_of(spline.control_points.begin(), spline.control_points.end(),
                   [](const Eigen::Vector3d& point) { return point.allFinite(); })) {
    return "a number is not finite";
  }
  if (!std::is_sorted(knots.begin(), knots.end()) || !(knots.front() < knots.back()) ||
      !std::isfinite(Range(knots))) {
    return "the knots do not ascend";
  }
  if (knots[kOrder - 1] != knots.front() || knots[count] != knots.back()) {
    return "the ends are not clamped";
  }
  for (size_t k = 1; k + kOrder < knots.size(); ++k) {
    if (knots[k] == knots[k + kOrder - 1]) return "a knot is repeated too often";
  }
  return "";
}

}  // namespace

bool CircularArc::IsCircle() const { return sweep_rad >= kFullTurn * (1 - 1e-12); }

const char* ShapeName(const CurveShape& shape) {
  return std::visit(
      Overloaded{[](const LineSegment&) { return "line"; },
                 [](const CircularArc& arc) { return arc.IsCircle() ? "circle" : "arc"; },
                 [](const CubicBSpline&) { return "spline"; }},
      shape);
}

std::string ValidateShape(const CurveShape& shape) {
  return std::visit([](const auto& s) -> std::string { return Broken(s); }, shape);
}

double AngleOn(const CircularArc& arc, const Eigen::Vector3d& point) {
  const Eigen::Vector3d offset = point - arc.center;
  return std::atan2(arc.y_axis.dot(offset), arc.x_axis.dot(offset));
}

double DistanceFromCircle(const CircularArc& arc, const Eigen::Vector3d& point) {
  return (point - ArcPoint(arc, AngleOn(arc, point))).norm();
}

Eigen::Vector3d PointAt(const CurveShape& shape, double t) {
  return std::visit(
      Overloaded{[&](const LineSegment& line) -> Eigen::Vector3d {
                   return (1 - t) * line.start + t * line.end;
                 },
                 [&](const CircularArc& arc) { return ArcPoint(arc, t * arc.sweep_rad); },
                 [&](const CubicBSpline& spline) { return SplinePoint(spline, t); }},
      shape);
}

Eigen::Vector3d DerivativeAt(const CurveShape& shape, double t) {
  return std::visit(
      Overloaded{[&](const LineSegment& line) -> Eigen::Vector3d { return line.end - line.start; },
                 [&](const CircularArc& arc) -> Eigen::Vector3d {
                   const double angle = t * arc.sweep_rad;
                   return arc.radius * arc.sweep_rad *
                          (std::cos(angle) * arc.y_axis - std::sin(angle) * arc.x_axis);
                 },
                 [&](const CubicBSpline& spline) { return SplineDerivative(spline, t); }},
      shape);
}

SplineBasis BasisAt(const std::vector<double>& knots, double t) {
  const double u = KnotAt(knots, t);
  const int span = SpanOf(knots, u);
  SplineBasis basis;
  basis.first = span - (kOrder - 1);
  BasisOfOrder(knots, span, u, kOrder, basis.value);
  return basis;
}

Polyline3d SampleShape(const CurveShape& shape, double tolerance) {
  return std::visit(
      Overloaded{[](const LineSegment& line) -> Polyline3d {
                   return {line.start, line.end};
                 },
                 [&](const CircularArc& arc) { return SampleArc(arc, tolerance); },
                 [&](const CubicBSpline& spline) { return SampleSpline(spline, tolerance); }},
      shape);
}

size_t NumNumbers(const CurveShape& shape) {
  return std::visit(Overloaded{[](const LineSegment&) -> size_t { return 6; },
                               [](const CircularArc&) -> size_t { return 11; },
                               [](const CubicBSpline& spline) {
                                 return spline.knots.size() + 3 * spline.control_points.size();
                               }},
                    shape);
}

CurveShape Transformed(const CurveShape& shape, double scale, const Eigen::Matrix3d& rotation,
                       const Eigen::Vector3d& translation) {
  const auto move = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return scale * (rotation * point) + translation;
  };
  return std::visit(Overloaded{[&](const LineSegment& line) -> CurveShape {
                                 return LineSegment{move(line.start), move(line.end)};
                               },
                               [&](CircularArc arc) -> CurveShape {
                                 arc.center = move(arc.center);
                                 arc.x_axis = rotation * arc.x_axis;
                                 arc.y_axis = rotation * arc.y_axis;
                                 arc.radius *= scale;
                                 return arc;
                               },
                               [&](CubicBSpline spline) -> CurveShape {
                                 for (Eigen::Vector3d& point : spline.control_points)
                                   point = move(point);
                                 return spline;
                               }},
                    shape);
}

}  // namespace limn
