// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/shape_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <ceres/ceres.h>

#include "limn/primitives/shape_solver.h"

namespace limn {
namespace {

// The shapes are linear in their points: one step is enough, a few more for the damping.
constexpr int kIterations = 5;

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
  SolveShape(&problem, kIterations);
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
  SolveShape(&problem, kIterations);
  return line;
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

ShapeResidual ResidualOf(const CurveShape& shape, const LinkSamples& link) {
  const std::vector<double> deviations = DeviationsPx(shape, link);
  double sum = 0;
  double weights = 0;
  ShapeResidual residual;
  for (size_t k = 0; k < deviations.size(); ++k) {
    const double weight = link.samples[k].weight;
    sum += weight * deviations[k] * deviations[k];
    weights += weight;
    if (weight == 1) residual.max_px = std::max(residual.max_px, deviations[k]);
  }
  residual.mean_square = sum / weights;
  return residual;
}

}  // namespace limn
