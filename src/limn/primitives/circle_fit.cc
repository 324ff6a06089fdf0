// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <ceres/ceres.h>

#include "limn/primitives/shape_fit.h"
#include "limn/primitives/shape_solver.h"

namespace limn {
namespace {

constexpr int kIterations = 25;

template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// The nearest point of a circle.
template <typename T>
Vector3<T> NearestOnCircle(const Vector3<T>& center, const Vector3<T>& normal, const T& radius,
                           const Eigen::Vector3d& position) {
  const Vector3<T> offset = position.cast<T>() - center;
  const Vector3<T> in_plane = offset - normal * normal.dot(offset);
  return center + in_plane * (radius / in_plane.norm());
}

// The circle through three points.
template <typename T>
struct Circumcircle {
  Vector3<T> center;
  Vector3<T> normal;
  T radius;

  Circumcircle(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
    const Vector3<T> u = b - a;
    const Vector3<T> v = c - a;
    const Vector3<T> w = u.cross(v);
    const T w2 = w.squaredNorm();
    const Vector3<T> to_center =
        (v.squaredNorm() * w.cross(u) + u.squaredNorm() * v.cross(w)) / (T(2) * w2);
    center = a + to_center;
    radius = to_center.norm();
    normal = w / sqrt(w2);
  }
};

struct ArcCost {
  const LinkSample3d& sample;

  template <typename T>
  bool operator()(const T* start, const T* middle, const T* end, T* residuals) const {
    using Map = Eigen::Map<const Vector3<T>>;
    const Circumcircle<T> circle{Vector3<T>(Map(start)), Vector3<T>(Map(middle)),
                                 Vector3<T>(Map(end))};
    const Vector3<T> nearest =
        NearestOnCircle<T>(circle.center, circle.normal, circle.radius, sample.position);
    Eigen::Map<Vector3<T>>(residuals, 3) =
        Root(sample).cast<T>() * (nearest - sample.position.cast<T>());
    return true;
  }
};

// Holds a point of a circle, which would otherwise slide along it; px.
struct SlideCost {
  const LinkSample3d& sample;
  double per_unit;  // px

  template <typename T>
  bool operator()(const T* point, T* residual) const {
    const Vector3<T> offset = Eigen::Map<const Vector3<T>>(point) - sample.position.cast<T>();
    *residual = T(per_unit) * offset.dot(sample.tangent.cast<T>());
    return true;
  }
};

// Keeps the middle point between the ends; px.
struct MiddleCost {
  double per_unit;  // px

  template <typename T>
  bool operator()(const T* start, const T* middle, const T* end, T* residual) const {
    using Map = Eigen::Map<const Vector3<T>>;
    const Vector3<T> chord = Map(end) - Map(start);
    const Vector3<T> offset = Map(middle) - (Map(end) + Map(start)) / T(2);
    *residual = T(per_unit) * offset.dot(chord) / chord.norm();
    return true;
  }
};

// Start, middle and end as one arc.
CircularArc ArcThrough(const Eigen::Vector3d& start, const Eigen::Vector3d& middle,
                       const Eigen::Vector3d& end) {
  const Circumcircle<double> circle(start, middle, end);
  CircularArc arc;
  arc.center = circle.center;
  arc.radius = circle.radius;
  arc.x_axis = (start - arc.center).normalized();
  arc.y_axis = circle.normal.cross(arc.x_axis).normalized();
  const Eigen::Vector3d to_end = end - arc.center;
  const double angle = std::atan2(arc.y_axis.dot(to_end), arc.x_axis.dot(to_end));
  arc.sweep_rad = angle > 0 ? angle : angle + 2 * M_PI;
  return arc;
}

const Eigen::Vector3d& MiddleOf(const LinkSamples& link) {
  return link.samples[link.samples.size() / 2].position;
}

}  // namespace

std::optional<CircularArc> FitArc(const LinkSamples& link, const EndConditions& ends) {
  Eigen::Vector3d start = link.samples.front().position;
  Eigen::Vector3d middle = MiddleOf(link);
  Eigen::Vector3d end = link.samples.back().position;
  // Smallest sagitta, px, to which a circle is fitted.
  constexpr double kMinSagittaPx = 1e-3;
  const double per_unit = 1 / link.footprint;
  const auto bends = [&] {
    const Eigen::Vector3d chord = end - start;
    return chord.norm() * per_unit > kMinSagittaPx &&
           (middle - start).cross(chord).norm() / chord.norm() * per_unit > kMinSagittaPx;
  };
  if (link.samples.size() < 4 || !bends()) return std::nullopt;
  ceres::Problem problem;
  for (const LinkSample3d& sample : link.samples) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<ArcCost, 3, 3, 3, 3>(new ArcCost{sample}), nullptr,
        start.data(), middle.data(), end.data());
  }
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<MiddleCost, 1, 3, 3, 3>(new MiddleCost{per_unit}), nullptr,
      start.data(), middle.data(), end.data());
  double* blocks[] = {start.data(), end.data()};
  const LinkSample3d* samples[] = {&link.samples.front(), &link.samples.back()};
  for (const int e : {0, 1}) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<SlideCost, 1, 3>(new SlideCost{*samples[e], per_unit}),
        nullptr, blocks[e]);
    if (ends[e].held) problem.SetParameterBlockConstant(blocks[e]);
  }
  SolveShape(&problem, kIterations);
  if (!bends()) return std::nullopt;
  const CircularArc arc = ArcThrough(start, middle, end);
  return ValidateShape(arc).empty() ? std::optional(arc) : std::nullopt;
}

std::optional<CircularArc> FitCircle(const LinkSamples& link, bool through_first) {
  // Smallest sine of the angle at the first of three points, a third of the link apart: 0.87 on a
  // circle.
  constexpr double kMinSine = 0.1;
  const size_t count = link.samples.size();
  if (count < 6) return std::nullopt;
  const LinkSample3d* samples[] = {&link.samples[0], &link.samples[count / 3],
                                   &link.samples[2 * count / 3]};
  Eigen::Vector3d points[] = {samples[0]->position, samples[1]->position, samples[2]->position};
  const auto is_wide = [&] {
    const Eigen::Vector3d u = points[1] - points[0];
    const Eigen::Vector3d v = points[2] - points[0];
    return u.cross(v).norm() > kMinSine * u.norm() * v.norm();
  };
  if (!is_wide()) return std::nullopt;
  ceres::Problem problem;
  for (const LinkSample3d& sample : link.samples) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<ArcCost, 3, 3, 3, 3>(new ArcCost{sample}), nullptr,
        points[0].data(), points[1].data(), points[2].data());
  }
  for (const int k : {0, 1, 2}) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<SlideCost, 1, 3>(
                                 new SlideCost{*samples[k], 1 / link.footprint}),
                             nullptr, points[k].data());
  }
  if (through_first) problem.SetParameterBlockConstant(points[0].data());
  SolveShape(&problem, kIterations);
  if (!is_wide()) return std::nullopt;
  CircularArc circle = ArcThrough(points[0], points[1], points[2]);
  circle.sweep_rad = 2 * M_PI;
  return ValidateShape(circle).empty() ? std::optional(circle) : std::nullopt;
}

}  // namespace limn
