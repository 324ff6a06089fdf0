#include "limn/primitives/shape_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <ceres/ceres.h>

namespace limn {
namespace {

// Keeps a point on its line: one degree of freedom.
class RayManifold final : public ceres::Manifold {
 public:
  explicit RayManifold(const Eigen::Vector3d& direction) : direction_(direction) {}
  int AmbientSize() const override { return 3; }
  int TangentSize() const override { return 1; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    Eigen::Map<Eigen::Vector3d> moved(x_plus_delta);
    moved = Eigen::Map<const Eigen::Vector3d>(x) + *delta * direction_;
    return true;
  }
  bool PlusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::Vector3d>(jacobian, 3) = direction_;
    return true;
  }
  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    *y_minus_x =
        direction_.dot(Eigen::Map<const Eigen::Vector3d>(y) - Eigen::Map<const Eigen::Vector3d>(x));
    return true;
  }
  bool MinusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::RowVector3d>(jacobian, 3) = direction_.transpose();
    return true;
  }

 private:
  Eigen::Vector3d direction_;
};

Eigen::Matrix3d Root(const LinkSample3d& sample) {
  return std::sqrt(sample.weight) * sample.across;
}

// across * (sum of weight * point - position): lines and splines are linear in their points.
class BlendCost final : public ceres::CostFunction {
 public:
  BlendCost(const LinkSample3d& sample, std::vector<double> weights)
      : sample_(sample), weights_(std::move(weights)) {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(weights_.size(), 3);
  }
  bool Evaluate(double const* const* points, double* residuals, double** jacobians) const override {
    Eigen::Vector3d offset = -sample_.position;
    for (size_t k = 0; k < weights_.size(); ++k) {
      offset += weights_[k] * Eigen::Map<const Eigen::Vector3d>(points[k]);
    }
    Eigen::Map<Eigen::Vector3d>(residuals, 3) = Root(sample_) * offset;
    for (size_t k = 0; jacobians != nullptr && k < weights_.size(); ++k) {
      if (jacobians[k] == nullptr) continue;
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> jacobian(jacobians[k]);
      jacobian = weights_[k] * Root(sample_);
    }
    return true;
  }

 private:
  LinkSample3d sample_;
  std::vector<double> weights_;
};

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

// An end of an arc slides along its circle unless it is told where to be; px.
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

void Solve(ceres::Problem* problem, int max_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = max_iterations;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, problem, &summary);
}

// The shape is linear in its points: one step is enough, a few more for the damping.
constexpr int kLinearIterations = 5;
constexpr int kArcIterations = 25;

double NearestParameter(const CurveShape& shape, const Eigen::Vector3d& position, double t) {
  for (int k = 0; k < 6; ++k) {
    const Eigen::Vector3d derivative = DerivativeAt(shape, t);
    const double slope = derivative.squaredNorm();
    if (!(slope > 0)) break;
    const double step = derivative.dot(position - PointAt(shape, t)) / slope;
    t = std::clamp(t + std::clamp(step, -0.1, 0.1), 0.0, 1.0);
  }
  return t;
}

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

// Sample parameters follow the shape as it is now.
std::vector<double> Parameters(const CubicBSpline& spline, const LinkSamples& link,
                               const std::vector<double>& before) {
  std::vector<double> t;
  for (size_t k = 0; k < link.samples.size(); ++k) {
    t.push_back(NearestParameter(spline, link.samples[k].position, before[k]));
  }
  return t;
}

void SolveSpline(const LinkSamples& link, const EndConditions& ends, bool closed,
                 const std::vector<double>& t, CubicBSpline* spline) {
  std::vector<Eigen::Vector3d>& points = spline->control_points;
  const size_t last = points.size() - 1;
  const auto block = [&](size_t k) { return points[closed && k == last ? 0 : k].data(); };
  ceres::Problem problem;
  for (size_t s = 0; s < link.samples.size(); ++s) {
    const SplineBasis basis = BasisAt(spline->knots, t[s]);
    std::vector<double*> blocks;
    for (int k = 0; k < 4; ++k) blocks.push_back(block(basis.first + k));
    problem.AddResidualBlock(new BlendCost(link.samples[s], {basis.value, basis.value + 4}),
                             nullptr, blocks);
  }
  for (const int end : {0, 1}) {
    if (!ends[end].held) continue;
    problem.SetParameterBlockConstant(block(end == 0 ? 0 : last));
    if (!ends[end].direction) continue;
    const size_t inner = end == 0 ? 1 : last - 1;
    const Eigen::Vector3d& at = points[end == 0 ? 0 : last];
    points[inner] =
        at + std::abs((points[inner] - at).dot(*ends[end].direction)) * *ends[end].direction;
    problem.SetManifold(points[inner].data(), new RayManifold(*ends[end].direction));
  }
  Solve(&problem, kLinearIterations);
  if (closed) points[last] = points[0];
}

}  // namespace

LineSegment FitLine(const LinkSamples& link, const EndConditions& ends) {
  LineSegment line = {link.samples.front().position, link.samples.back().position};
  if (ends[0].held && ends[1].held) return line;
  ceres::Problem problem;
  for (const LinkSample3d& sample : link.samples) {
    problem.AddResidualBlock(new BlendCost(sample, {1 - sample.t, sample.t}), nullptr,
                             line.start.data(), line.end.data());
  }
  if (ends[0].held) problem.SetParameterBlockConstant(line.start.data());
  if (ends[1].held) problem.SetParameterBlockConstant(line.end.data());
  Solve(&problem, kLinearIterations);
  return line;
}

std::optional<CircularArc> FitArc(const LinkSamples& link, const EndConditions& ends) {
  Eigen::Vector3d start = link.samples.front().position;
  Eigen::Vector3d middle = MiddleOf(link);
  Eigen::Vector3d end = link.samples.back().position;
  // Less than this sagitta, px, is no bend that a circle could be fitted to.
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
  Solve(&problem, kArcIterations);
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
  Solve(&problem, kArcIterations);
  const Eigen::Vector3d first = link.samples.front().position - center;
  CircularArc circle;
  circle.center = center;
  circle.radius = std::abs(radius);
  circle.x_axis = (first - normal.dot(first) * normal).normalized();
  circle.y_axis = normal.cross(circle.x_axis).normalized();
  circle.sweep_rad = 2 * M_PI;
  return ValidateShape(circle).empty() ? std::optional(circle) : std::nullopt;
}

CubicBSpline FitSpline(const LinkSamples& link, const EndConditions& ends, bool closed,
                       std::vector<double> knots) {
  constexpr int kRounds = 2;
  CubicBSpline spline;
  spline.knots = std::move(knots);
  const size_t count = spline.knots.size() - 4;
  // On the link, at the mean of three knots each.
  const size_t last = link.samples.size() - 1;
  for (size_t k = 0; k < count; ++k) {
    const double mean = (spline.knots[k + 1] + spline.knots[k + 2] + spline.knots[k + 3]) / 3;
    const double at = mean * static_cast<double>(last);
    const size_t before = std::min(static_cast<size_t>(at), last - 1);
    const double part = at - static_cast<double>(before);
    spline.control_points.push_back((1 - part) * link.samples[before].position +
                                    part * link.samples[before + 1].position);
  }
  std::vector<double> t;
  for (const LinkSample3d& sample : link.samples) t.push_back(sample.t);
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) t = Parameters(spline, link, t);
    SolveSpline(link, ends, closed, t, &spline);
  }
  return spline;
}

std::vector<double> DeviationsPx(const CurveShape& shape, const LinkSamples& link) {
  std::vector<double> deviations;
  for (const LinkSample3d& sample : link.samples) {
    const double t = NearestParameter(shape, sample.position, sample.t);
    deviations.push_back((sample.across * (PointAt(shape, t) - sample.position)).norm());
  }
  return deviations;
}

}  // namespace limn
