// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/camera_projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/LU>
#include <unsupported/Eigen/AutoDiff>

#include "colmap_ext/model/distortion.h"
#include "limn/util/angles.h"

namespace limn::colmap_ext {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Vector2d>;

constexpr double kMaxAngleRad = 75 * kDeg;
constexpr int kNumAngles = 301;  // every quarter of a degree
constexpr int kNumDirections = 32;
constexpr int kMaxIterations = 50;
constexpr double kTolerance = 1e-12;

struct Linearized {
  Eigen::Vector2d value;
  Eigen::Matrix2d jacobian;
};

Linearized DistortWithJacobian(const Intrinsics& intrinsics, const Eigen::Vector2d& ray) {
  const distortion::Point<Dual> p = {Dual(ray.x(), 2, 0), Dual(ray.y(), 2, 1)};
  const auto q = distortion::Distort(intrinsics, p);
  Linearized result;
  result.value = {q.u.value(), q.v.value()};
  result.jacobian.row(0) = q.u.derivatives().transpose();
  result.jacobian.row(1) = q.v.derivatives().transpose();
  return result;
}

double Radius(int step) { return std::tan(kMaxAngleRad * step / (kNumAngles - 1)); }

// Positive determinant in all directions; written so that NaN fails.
bool InvertibleAtRadius(const Intrinsics& intrinsics, double radius) {
  for (int i = 0; i < kNumDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kNumDirections;
    const Eigen::Vector2d ray(radius * std::cos(angle), radius * std::sin(angle));
    const Linearized at = DistortWithJacobian(intrinsics, ray);
    if (!(at.jacobian.determinant() > 0 && at.value.allFinite())) return false;
  }
  return true;
}

double DistortedRadius(const Intrinsics& intrinsics, double radius) {
  const auto q = distortion::Distort<double>(intrinsics, {radius, 0.0});
  return std::hypot(q.u, q.v);
}

}  // namespace

CameraProjection::CameraProjection(Intrinsics intrinsics) : intrinsics_(std::move(intrinsics)) {
  for (int step = 0; step < kNumAngles; ++step) {
    const double radius = Radius(step);
    if (!InvertibleAtRadius(intrinsics_, radius)) break;
    const double distorted = DistortedRadius(intrinsics_, radius);
    if (step > 0 && !(distorted > distorted_radius_.back())) break;
    max_radius_ = radius;
    distorted_radius_.push_back(distorted);
  }
}

std::optional<Eigen::Vector2d> CameraProjection::PixelFromRay(const Eigen::Vector2d& ray) const {
  if (!(ray.squaredNorm() <= max_radius_ * max_radius_)) return std::nullopt;
  const auto q = distortion::Distort<double>(intrinsics_, {ray.x(), ray.y()});
  return Eigen::Vector2d(intrinsics_.fx * q.u + intrinsics_.cx,
                         intrinsics_.fy * q.v + intrinsics_.cy);
}

// The radial part of the distortion inverted by the table, in the direction of the distorted point.
Eigen::Vector2d CameraProjection::StartFor(const Eigen::Vector2d& distorted) const {
  const double target = distorted.norm();
  const auto above = std::upper_bound(distorted_radius_.begin(), distorted_radius_.end(), target);
  if (above == distorted_radius_.begin()) return Eigen::Vector2d::Zero();
  const int step = static_cast<int>(above - distorted_radius_.begin());
  double radius = max_radius_;
  if (above != distorted_radius_.end()) {
    const double below = distorted_radius_[step - 1];
    const double t = (target - below) / (*above - below);
    radius = (1 - t) * Radius(step - 1) + t * Radius(step);
  }
  return target > 0 ? Eigen::Vector2d(distorted * (radius / target)) : Eigen::Vector2d::Zero();
}

std::optional<Eigen::Vector2d> CameraProjection::RayFromPixel(const Eigen::Vector2d& pixel) const {
  if (max_radius_ == 0 || !pixel.allFinite()) return std::nullopt;
  const Eigen::Vector2d distorted((pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                                  (pixel.y() - intrinsics_.cy) / intrinsics_.fy);
  Eigen::Vector2d ray = StartFor(distorted);
  for (int i = 0; i < kMaxIterations; ++i) {
    const Linearized at = DistortWithJacobian(intrinsics_, ray);
    const Eigen::Vector2d residual = at.value - distorted;
    if (residual.norm() <= kTolerance * (1 + distorted.norm())) {
      if (!(ray.norm() <= max_radius_)) return std::nullopt;
      return ray;
    }
    Eigen::Vector2d step = at.jacobian.inverse() * residual;
    // Keep the iteration near the domain: outside it the models mean nothing.
    const double limit = 0.5 * (1 + ray.norm());
    if (!(step.norm() <= limit)) step *= limit / step.norm();
    if (!step.allFinite()) return std::nullopt;
    ray -= step;
  }
  return std::nullopt;
}

}  // namespace limn::colmap_ext
