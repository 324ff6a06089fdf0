// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/equal_circles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace limn {
namespace {

double NameCost(const std::vector<ArcEvidence>& arcs) {
  return std::log(std::max<double>(2, static_cast<double>(arcs.size())));
}

// Of a move across the circle, px.
double Pixels(const ArcEvidence& arc, double move) {
  return std::abs(move) * std::sqrt(arc.metric.trace() / 2);
}

// Those that are long enough, the longest first.
std::vector<int> Candidates(const std::vector<ArcEvidence>& arcs) {
  std::vector<int> order;
  for (size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i].length_px >= kMinRegularLengthPx) order.push_back(static_cast<int>(i));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return arcs[a].length_px > arcs[b].length_px; });
  return order;
}

// Partitions the candidates: each class is a seed with all later ones that join it.
template <class Class, class Start, class Joins>
std::vector<Class> Classes(std::vector<int> candidates, const Start& start, const Joins& joins) {
  std::vector<Class> classes;
  while (!candidates.empty()) {
    Class found = start(candidates.front());
    std::vector<int> left;
    for (const int i : candidates) {
      if (i == candidates.front() || joins(i, &found)) {
        found.arcs.push_back(i);
      } else {
        left.push_back(i);
      }
    }
    candidates = std::move(left);
    if (found.arcs.size() < 2) continue;
    std::sort(found.arcs.begin(), found.arcs.end());
    classes.push_back(std::move(found));
  }
  return classes;
}

// Where an arc is off an axis: its center across the axis, and its tilt times the radius.
Eigen::Vector4d OffAxis(const ArcEvidence& arc, const AxisClass& axis) {
  const Eigen::Vector3d& x = arc.arc.x_axis;
  const Eigen::Vector3d& y = arc.arc.y_axis;
  const double along = axis.direction.dot(arc.arc.Normal());
  const Eigen::Vector3d to_axis = axis.point - arc.arc.center;
  // Where the axis meets the plane of the arc.
  const Eigen::Vector3d offset = to_axis - to_axis.dot(arc.arc.Normal()) / along * axis.direction;
  return {offset.dot(x), offset.dot(y), arc.arc.radius * axis.direction.dot(x) / along,
          arc.arc.radius * axis.direction.dot(y) / along};
}

Eigen::Matrix4d AxisCovariance(const ArcEvidence& arc) {
  Eigen::Matrix<double, 4, 6> of = Eigen::Matrix<double, 4, 6>::Zero();
  of.block<1, 3>(0, 0) = arc.arc.x_axis.transpose();
  of.block<1, 3>(1, 0) = arc.arc.y_axis.transpose();
  of(2, 3) = 1;
  of(3, 4) = 1;
  return of * arc.covariance * of.transpose();
}

// Of the axis of an arc at another center.
Eigen::Matrix4d AxisCovarianceAt(const ArcEvidence& seed, const ArcEvidence& other) {
  Eigen::Matrix4d covariance = AxisCovariance(seed);
  const Eigen::Matrix2d tilt =
      covariance.bottomRightCorner<2, 2>() / (seed.arc.radius * seed.arc.radius);
  const double height = seed.arc.Normal().dot(other.arc.center - seed.arc.center);
  covariance.topLeftCorner<2, 2>() += height * height * tilt;
  covariance.bottomRightCorner<2, 2>() = other.arc.radius * other.arc.radius * tilt;
  return covariance;
}

}  // namespace

std::vector<RadiusClass> FindEqualRadii(const std::vector<ArcEvidence>& arcs,
                                        const RegularityOptions& options) {
  const double name_cost = NameCost(arcs);
  double variance = 0;  // of the class at work
  return Classes<RadiusClass>(
      Candidates(arcs),
      [&](int seed) {
        variance = arcs[seed].covariance(5, 5);
        return RadiusClass{arcs[seed].arc.radius, {}};
      },
      [&](int i, RadiusClass* found) {
        const double off = arcs[i].arc.radius - found->radius;
        const double own_variance = arcs[i].covariance(5, 5);
        const double sum = variance + own_variance;
        const double saved = std::log(arcs[i].arc.radius / std::sqrt(2 * M_PI * sum)) - name_cost;
        if (saved <= 0.5 * off * off / sum || Pixels(arcs[i], off) > options.max_shift_px) {
          return false;
        }
        found->radius += off * variance / sum;
        variance *= own_variance / sum;
        return true;
      });
}

std::vector<AxisClass> FindCommonAxes(const std::vector<ArcEvidence>& arcs,
                                      const RegularityOptions& options) {
  constexpr double kMinCosine = 0.9;
  const double name_cost = NameCost(arcs);
  double reach = 1;
  for (const ArcEvidence& arc : arcs) reach = std::max(reach, 2 * arc.arc.center.norm());
  const ArcEvidence* of_axis = nullptr;
  return Classes<AxisClass>(
      Candidates(arcs),
      [&](int seed) {
        of_axis = &arcs[seed];
        return AxisClass{of_axis->arc.center, of_axis->arc.Normal(), {}};
      },
      [&](int i, AxisClass* axis) {
        const ArcEvidence& arc = arcs[i];
        if (std::abs(axis->direction.dot(arc.arc.Normal())) < kMinCosine) return false;
        const Eigen::Vector4d off = OffAxis(arc, *axis);
        const double move = off.head<2>().norm() + off.tail<2>().norm();
        if (Pixels(arc, move) > options.max_shift_px) return false;
        const Eigen::Matrix4d covariance = AxisCovariance(arc) + AxisCovarianceAt(*of_axis, arc);
        const double saved = 2 * std::log(reach * arc.arc.radius / (2 * M_PI)) -
                             0.5 * std::log(std::max(covariance.determinant(), 1e-24)) - name_cost;
        return saved > 0.5 * off.dot(covariance.ldlt().solve(off));
      });
}

}  // namespace limn
