// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/rod_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Dense>

#include "limn/geometry/tangent_frame.h"

namespace limn {
namespace {

// Lines are fixed for this many places, so that they can follow a bent rod.
constexpr size_t kWindowPlaces = 24;
// Directions in which the first line may start, and steps of its fit.
constexpr int kNumStarts = 6;
constexpr int kNumSteps = 3;
constexpr double kLineRobustPx = 0.5;
constexpr double kMaxDistancePx = 1;
// Standard deviation of the lines about the radius, px: it decides only what edgels leave open.
constexpr double kLinePriorPx = 3;
// A view with fewer edgels counts in proportion to them.
constexpr double kManyEdgels = 20;
// What calibration and sampling add to all edgels of a view alike, px.
constexpr double kSystematicPx = 0.2;

// An edgel, linearized in an offset of the curve it lies on, in the plane across the rod.
struct Observation {
  ViewId view = -1;
  Eigen::Vector2d to_outline = Eigen::Vector2d::Zero();
  double at_axis_px = 0;  // distance of the axis
  double of_rod_px = 0;   // of the rod's outline
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();

  // Distance of an outline that is one of two lines.
  double At(const Eigen::Vector2d& line, const Eigen::Vector2d& other) const {
    const double half_px = gradient.dot(line - other) / 2;
    const double apart_px = std::copysign(SeenHalfWidth(std::abs(half_px)), half_px);
    return at_axis_px + gradient.dot(line + other) / 2 + apart_px;
  }
};

double Cost(double distance_px) {
  return std::min(distance_px * distance_px, kMaxDistancePx * kMaxDistancePx);
}

std::vector<Observation> Observe(const TopologyInput& input, std::span<const RodPlace> places) {
  std::vector<Observation> observations;
  Eigen::Matrix<double, 3, 2> across = TangentFrame(places.front().tangent);
  for (const RodPlace& place : places) {
    if (!place.IsShown()) continue;
    // The frame turns with the axis, without twist.
    across -= place.tangent * (place.tangent.transpose() * across);
    across.col(0).normalize();
    across.col(1) = place.tangent.cross(across.col(0));
    for (const RodSight& sight : place.sights) {
      for (const int side : {0, 1}) {
        const Eigen::Vector3d to_outline = sight.ToOutline(side);
        const auto residual =
            input.Residual(sight.edgels[side], place.position + sight.seen_radius * to_outline);
        if (!residual) continue;
        const double to_axis = sight.seen_radius * residual->gradient.dot(to_outline);
        observations.push_back({sight.view, across.transpose() * to_outline,
                                residual->residual_px - to_axis, residual->residual_px,
                                across.transpose() * residual->gradient});
      }
    }
  }
  return observations;
}

// Two lines; an outline is the one on its side.
using FixedLines = std::array<Eigen::Vector2d, 2>;

int LineOf(const FixedLines& lines, const Observation& observation) {
  return (lines[1] - lines[0]).dot(observation.to_outline) > 0;
}

FixedLines Stepped(const FixedLines& lines, const Rod& rod,
                   std::span<const Observation> observations) {
  const double prior = std::pow(kLinePriorPx * rod.footprint, -2);
  std::array<Eigen::Matrix2d, 2> normal;
  normal.fill(prior * Eigen::Matrix2d::Identity());
  FixedLines right = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  for (const Observation& observation : observations) {
    const int line = LineOf(lines, observation);
    const double distance = observation.At(lines[line], lines[1 - line]);
    const double weight = std::min(1.0, kLineRobustPx / std::max(std::abs(distance), 1e-12));
    normal[line] += weight * observation.gradient * observation.gradient.transpose();
    right[line] -= weight * distance * observation.gradient;
  }
  FixedLines stepped = lines;
  for (const int line : {0, 1}) stepped[line] += normal[line].ldlt().solve(right[line]);
  return stepped;
}

double CostOf(const FixedLines& lines, std::span<const Observation> observations) {
  double cost = 0;
  for (const Observation& observation : observations) {
    const int line = LineOf(lines, observation);
    cost += Cost(observation.At(lines[line], lines[1 - line]));
  }
  return cost;
}

FixedLines FitLines(const Rod& rod, std::span<const Observation> observations) {
  FixedLines best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (int start = 0; start < kNumStarts; ++start) {
    const double angle = M_PI * start / kNumStarts;
    const Eigen::Vector2d offset = rod.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    FixedLines lines = {-offset, offset};
    for (int step = 0; step < kNumSteps; ++step) lines = Stepped(lines, rod, observations);
    const double cost = CostOf(lines, observations);
    if (cost >= best_cost) continue;
    best_cost = cost;
    best = lines;
  }
  return best;
}

struct ViewCosts {
  double rod = 0;
  double lines = 0;
  int num_edgels = 0;

  // Of the likelihoods, if all edgels of the view err alike and each hypothesis by what it shows.
  double LogRatio() const {
    const auto variance = [&](double cost) {
      return cost / num_edgels + kSystematicPx * kSystematicPx;
    };
    return std::min(1.0, num_edgels / kManyEdgels) * std::log(variance(lines) / variance(rod)) / 2;
  }
};

}  // namespace

RodEvidence CompareWithFixedLines(const TopologyInput& input, const Rod& rod,
                                  std::span<const RodPlace> places) {
  std::map<ViewId, ViewCosts> by_view;
  for (size_t begin = 0; begin < places.size(); begin += kWindowPlaces) {
    const auto window = places.subspan(begin, std::min(kWindowPlaces, places.size() - begin));
    const std::vector<Observation> observations = Observe(input, window);
    const FixedLines lines = FitLines(rod, observations);
    for (const Observation& observation : observations) {
      const int line = LineOf(lines, observation);
      const double of_lines_px = observation.At(lines[line], lines[1 - line]);
      // Others are of something else.
      if (std::min(std::abs(observation.of_rod_px), std::abs(of_lines_px)) > kMaxDistancePx)
        continue;
      ViewCosts& costs = by_view[observation.view];
      costs.rod += Cost(observation.of_rod_px);
      costs.lines += Cost(of_lines_px);
      ++costs.num_edgels;
    }
  }
  RodEvidence evidence;
  double cost = 0;
  int num_edgels = 0;
  for (const auto& [view, costs] : by_view) {
    cost += costs.rod;
    num_edgels += costs.num_edgels;
    evidence.num_views += costs.num_edgels >= kManyEdgels;
    evidence.log_ratio += costs.LogRatio();
  }
  if (num_edgels > 0) evidence.rms_px = std::sqrt(cost / num_edgels);
  return evidence;
}

}  // namespace limn
