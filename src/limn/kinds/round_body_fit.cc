// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/round_body_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <ceres/ceres.h>

#include "limn/geometry/tangent_frame.h"
#include "limn/util/median.h"
#include "limn/util/quiet_solver.h"

namespace limn {
namespace {

constexpr int kMaxBodyIterations = 50;
constexpr size_t kMinBodyViews = 4;
// Farther from the body, an edgel is of something else; this share must be nearer.
constexpr double kOffBodyPx = 1.5;
constexpr double kMinOnBody = 0.8;
constexpr double kMaxRadiusError = 0.05;
// A shape with more unknowns must lower the mean squared misfit to this share. Below some px^2
// misfits do not tell shapes apart: that is added to both.
constexpr double kMuchBetter = 0.8;
constexpr double kLeastMisfit = 0.01;
// Information that is nearer to singular does not determine a body.
constexpr double kMinCondition = 1e-12;
constexpr double kMinAxisPx = 3;

template <typename T>
using BodyVector = Eigen::Matrix<T, 3, 1>;

// Where the unknowns of a body begin: a part of its axis, and two directions across it.
struct AxisFrame {
  Eigen::Vector3d start;
  Eigen::Vector3d end;
  Eigen::Matrix<double, 3, 2> across;
};

// A line of sight touches a body if its least distance from the surface is 0. The radius is linear
// along the axis, r0 + slope * h. Along the line, the squared distance from the axis is a s^2 +
// d^2; the least value of sqrt(a s^2 + d^2) - slope * (h + s * along) has a closed form.
template <typename T>
T GapOfCone(const OutlineSight& sight, const BodyVector<T>& start, const BodyVector<T>& end,
            const T& start_radius, const T& end_radius) {
  const BodyVector<T> axis = end - start;
  const T length = axis.norm();
  const BodyVector<T> unit = axis / length;
  const BodyVector<T> ray = sight.ray.cast<T>();
  const BodyVector<T> from_start = sight.center.cast<T>() - start;
  const T along = ray.dot(unit);
  const BodyVector<T> ray_across = ray - along * unit;
  const BodyVector<T> across = from_start - from_start.dot(unit) * unit;
  const T a = ray_across.squaredNorm();
  const T nearest = -ray_across.dot(across) / a;
  const T distance = (across + nearest * ray_across).norm();
  const T slope = (end_radius - start_radius) / length;
  const T radius = start_radius + slope * (from_start.dot(unit) + nearest * along);
  using std::max;
  const T lean = max(T(1e-6), T(1) - slope * slope * along * along / a);
  return (distance * sqrt(lean) - radius) / sqrt(T(1) + slope * slope);
}

template <typename T>
T GapOfSphere(const OutlineSight& sight, const BodyVector<T>& center, const T& radius) {
  const BodyVector<T> from = center - sight.center.cast<T>();
  const BodyVector<T> ray = sight.ray.cast<T>();
  return (from - from.dot(ray) * ray).norm() - radius;
}

struct SphereCost {
  const OutlineSight& sight;

  template <typename T>
  bool operator()(const T* unknowns, T* residual) const {
    const BodyVector<T> center(unknowns[0], unknowns[1], unknowns[2]);
    *residual = T(sight.px_per_unit) * GapOfSphere<T>(sight, center, unknowns[3]);
    return true;
  }
};

// Unknowns: motions of start and end across the axis, then the one radius of a cylinder or the two
// of a cone.
template <int kRadii>
struct AxisCost {
  const OutlineSight& sight;
  const AxisFrame& frame;

  template <typename T>
  bool operator()(const T* unknowns, T* residual) const {
    const Eigen::Matrix<T, 3, 2> across = frame.across.cast<T>();
    const BodyVector<T> start =
        frame.start.cast<T>() + across * Eigen::Matrix<T, 2, 1>(unknowns[0], unknowns[1]);
    const BodyVector<T> end =
        frame.end.cast<T>() + across * Eigen::Matrix<T, 2, 1>(unknowns[2], unknowns[3]);
    *residual =
        T(sight.px_per_unit) * GapOfCone<T>(sight, start, end, unknowns[4], unknowns[3 + kRadii]);
    return true;
  }
};

struct FittedBody {
  RoundBody body;
  double mean_squared = 0;  // of misfits up to kOffBodyPx
  double on_body = 0;       // share of the sights
};

// Minimizes the misfits of all sights over the unknowns. The inverse of the information that they
// give, or nothing if they do not determine them.
template <int kUnknowns, typename MakeCost>
std::optional<Eigen::Matrix<double, kUnknowns, kUnknowns>> Solve(
    const std::vector<OutlineSight>& sights, const MakeCost& make_cost,
    std::array<double, kUnknowns>* unknowns) {
  using Information = Eigen::Matrix<double, kUnknowns, kUnknowns>;
  const QuietSolver quiet;
  ceres::Problem problem;
  for (const OutlineSight& sight : sights) {
    problem.AddResidualBlock(make_cost(sight), new ceres::HuberLoss(kOutlineRobustPx),
                             unknowns->data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = kMaxBodyIterations;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  ceres::CRSMatrix jacobian;
  problem.Evaluate({}, nullptr, nullptr, nullptr, &jacobian);
  Information information = Information::Zero();
  for (int row = 0; row < jacobian.num_rows; ++row) {
    const Eigen::Map<const Eigen::Matrix<double, kUnknowns, 1>> gradient(
        &jacobian.values[jacobian.rows[row]]);
    information += gradient * gradient.transpose();
  }
  const Eigen::LDLT<Information> factors(information);
  if (!(factors.rcond() > kMinCondition)) return std::nullopt;
  const Information covariance = factors.solve(Information::Identity());
  if (!(covariance.diagonal().minCoeff() > 0)) return std::nullopt;
  return covariance;
}

double MisfitPx(const OutlineSight& sight, const RoundBody& body) {
  const double gap =
      body.shape == RoundShape::kSphere
          ? GapOfSphere<double>(sight, body.start, body.start_radius)
          : GapOfCone<double>(sight, body.start, body.end, body.start_radius, body.end_radius);
  return gap * sight.px_per_unit;
}

// Fills in what the sights say about the body. `radius_variance` is that of independent edgels of 1
// px.
FittedBody Measure(const std::vector<OutlineSight>& sights, RoundBody body,
                   double radius_variance) {
  FittedBody fitted;
  double sum = 0, sum_on = 0;
  int num_on = 0;
  std::set<ViewId> views;
  for (const OutlineSight& sight : sights) {
    const double squared = std::pow(MisfitPx(sight, body), 2);
    views.insert(sight.view);
    sum += std::min(squared, kOffBodyPx * kOffBodyPx);
    if (!(squared < kOffBodyPx * kOffBodyPx)) continue;
    sum_on += squared;
    ++num_on;
  }
  const auto count = static_cast<double>(sights.size());
  body.rms_px = num_on > 0 ? std::sqrt(sum_on / num_on) : kOffBodyPx;
  const double per_view = count / static_cast<double>(views.size());
  const double variance = body.rms_px * body.rms_px + per_view * kAlikePx * kAlikePx;
  body.radius_sigma = std::sqrt(radius_variance * variance);
  fitted.body = body;
  fitted.mean_squared = sum / count;
  fitted.on_body = num_on / count;
  return fitted;
}

std::optional<FittedBody> FitSphere(const std::vector<OutlineSight>& sights,
                                    const Eigen::Vector3d& center, double radius) {
  std::array<double, 4> unknowns = {center.x(), center.y(), center.z(), radius};
  const auto covariance = Solve<4>(
      sights,
      [](const OutlineSight& sight) {
        return new ceres::AutoDiffCostFunction<SphereCost, 1, 4>(new SphereCost{sight});
      },
      &unknowns);
  if (!covariance) return std::nullopt;
  RoundBody body;
  body.shape = RoundShape::kSphere;
  body.start = body.end = Eigen::Vector3d(unknowns[0], unknowns[1], unknowns[2]);
  body.start_radius = body.end_radius = unknowns[3];
  return Measure(sights, body, (*covariance)(3, 3));
}

// A cone that outlines show up to its apex may end beyond it, where radii are below 0.
void CutAtApex(RoundBody* cone) {
  const double at = cone->start_radius / (cone->start_radius - cone->end_radius);
  const Eigen::Vector3d apex = cone->start + at * (cone->end - cone->start);
  if (cone->start_radius < 0 && cone->end_radius > 0) {
    cone->start = apex;
    cone->start_radius = 0;
  } else if (cone->end_radius < 0 && cone->start_radius > 0) {
    cone->end = apex;
    cone->end_radius = 0;
  }
}

// A cylinder, with one radius, or a cone, with two.
template <int kRadii>
std::optional<FittedBody> FitOnAxis(const std::vector<OutlineSight>& sights, const AxisFrame& frame,
                                    double radius) {
  constexpr int kUnknowns = 4 + kRadii;
  std::array<double, kUnknowns> unknowns = {};
  std::fill(unknowns.begin() + 4, unknowns.end(), radius);
  const auto covariance = Solve<kUnknowns>(
      sights,
      [&](const OutlineSight& sight) {
        return new ceres::AutoDiffCostFunction<AxisCost<kRadii>, 1, kUnknowns>(
            new AxisCost<kRadii>{sight, frame});
      },
      &unknowns);
  if (!covariance) return std::nullopt;
  RoundBody body;
  body.shape = kRadii == 1 ? RoundShape::kCylinder : RoundShape::kCone;
  body.start = frame.start + frame.across * Eigen::Vector2d(unknowns[0], unknowns[1]);
  body.end = frame.end + frame.across * Eigen::Vector2d(unknowns[2], unknowns[3]);
  body.start_radius = unknowns[4];
  body.end_radius = unknowns.back();
  if (body.shape == RoundShape::kCone) CutAtApex(&body);
  const double of_radii = covariance->template bottomRightCorner<kRadii, kRadii>().sum();
  return Measure(sights, body, of_radii / (kRadii * kRadii));
}

bool IsCredible(const FittedBody& fitted) {
  const RoundBody& body = fitted.body;
  return Validate(body).empty() && fitted.on_body >= kMinOnBody &&
         body.radius_sigma < kMaxRadiusError * body.MeanRadius();
}

// The middle of the axis points, and their main direction times how far they reach along it.
AxisFrame FrameOf(const std::vector<OutlineSight>& sights) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const OutlineSight& sight : sights) middle += sight.axis_point;
  middle /= static_cast<double>(sights.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const OutlineSight& sight : sights) {
    const Eigen::Vector3d offset = sight.axis_point - middle;
    spread += offset * offset.transpose();
  }
  const Eigen::Vector3d unit =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  double least = 0, most = 0;
  for (const OutlineSight& sight : sights) {
    const double along = unit.dot(sight.axis_point - middle);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  return {middle + least * unit, middle + most * unit, TangentFrame(unit)};
}

}  // namespace

std::optional<RoundBody> FitRoundBody(const std::vector<OutlineSight>& sights) {
  std::set<ViewId> views;
  std::vector<double> radii, scales;
  for (const OutlineSight& sight : sights) {
    views.insert(sight.view);
    radii.push_back(sight.radius);
    scales.push_back(sight.px_per_unit);
  }
  if (views.size() < kMinBodyViews) return std::nullopt;
  const double radius = Median(std::move(radii));
  const double px_per_unit = Median(std::move(scales));
  const AxisFrame frame = FrameOf(sights);
  std::vector<std::optional<FittedBody>> fits = {
      FitSphere(sights, 0.5 * (frame.start + frame.end), radius)};
  if ((frame.end - frame.start).norm() * px_per_unit > kMinAxisPx) {
    fits.push_back(FitOnAxis<1>(sights, frame, radius));
    fits.push_back(FitOnAxis<2>(sights, frame, radius));
  }
  std::optional<FittedBody> best;
  for (const std::optional<FittedBody>& fit : fits) {
    if (!fit) continue;
    if (!best ||
        fit->mean_squared + kLeastMisfit < kMuchBetter * (best->mean_squared + kLeastMisfit)) {
      best = fit;
    }
  }
  if (!best || !IsCredible(*best)) return std::nullopt;
  return best->body;
}

}  // namespace limn
