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

// Holds an end of an arc, which would otherwise slide along its circle; px.
struct EndCost {
  const LinkSample3d& sample;
  double per_unit;  // px

  template <typename T>
  bool operator()(const T* end, T* residual) const {
    const Vector3<T> offset = Eigen::Map<const Vector3<T>>(end) - sample.position.cast<T>();
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

struct CircleCost {
  const LinkSample3d& sample;

  template <typename T>
  bool operator()(const T* center, const T* normal, const T* radius, T* residuals) const {
    using Map = Eigen::Map<const Vector3<T>>;
    const Vector3<T> nearest = NearestOnCircle<T>(Vector3<T>(Map(center)), Vector3<T>(Map(normal)),
                                                  *radius, sample.position);
    Eigen::Map<Vector3<T>>(residuals, 3) =
        Root(sample).cast<T>() * (nearest - sample.position.cast<T>());
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
        new ceres::AutoDiffCostFunction<EndCost, 1, 3>(new EndCost{*samples[e], per_unit}), nullptr,
        blocks[e]);
    if (ends[e].held) problem.SetParameterBlockConstant(blocks[e]);
  }
  SolveShape(&problem, kIterations);
  if (!bends()) return std::nullopt;
  const CircularArc arc = ArcThrough(start, middle, end);
  return ValidateShape(arc).empty() ? std::optional(arc) : std::nullopt;
}

std::optional<CircularArc> FitCircle(const LinkSamples& link) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const LinkSample3d& sample : link.samples) center += sample.position;
  center /= static_cast<double>(link.samples.size());
  // Twice the area vector: normal and sense of the turn.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double radius = 0;
  for (size_t k = 0; k < link.samples.size(); ++k) {
    const Eigen::Vector3d offset = link.samples[k].position - center;
    radius += offset.norm() / static_cast<double>(link.samples.size());
    if (k > 0) normal += (link.samples[k - 1].position - center).cross(offset);
  }
  if (link.samples.size() < 6 || !(normal.norm() > 0.1 * radius * radius)) return std::nullopt;
  normal.normalize();
  ceres::Problem problem;
  for (const LinkSample3d& sample : link.samples) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<CircleCost, 3, 3, 3, 1>(new CircleCost{sample}), nullptr,
        center.data(), normal.data(), &radius);
  }
  problem.SetManifold(normal.data(), new ceres::SphereManifold<3>());
  SolveShape(&problem, kIterations);
  const Eigen::Vector3d first = link.samples.front().position - center;
  CircularArc circle;
  circle.center = center;
  circle.radius = std::abs(radius);
  circle.x_axis = (first - normal.dot(first) * normal).normalized();
  circle.y_axis = normal.cross(circle.x_axis).normalized();
  circle.sweep_rad = 2 * M_PI;
  return ValidateShape(circle).empty() ? std::optional(circle) : std::nullopt;
}

}  // namespace limn
