// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/grow_rod.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "limn/geometry/angle_between.h"
#include "limn/rods/fit_rod.h"
#include "limn/rods/rod_limits.h"
#include "limn/rods/rod_sights.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr SupportGate kGrowthGates[] = {
    {2.0, 1.0, 35 * kDeg}, {1.5, 1.0, 25 * kDeg}, {1.0, 1.0, 20 * kDeg}};
constexpr SupportGate kGrownGate = {1.0, 1.0, 20 * kDeg};
constexpr int kMaxGapSegments = 2;
constexpr double kMinGrownShare = 0.6;
constexpr double kMaxGrowthTurnRad = 35 * kDeg;
constexpr double kBesidePx = 1;
// A rod ends before it comes this near to itself, in radii.
constexpr double kOwnReach = 3;
constexpr size_t kMaxAxisPoints = 2000;

bool ComesBack(const Rod& rod) {
  const size_t near = 1 + static_cast<size_t>(kOwnReach * kMaxRadiusPx / kAxisStepPx);
  if (rod.axis.size() <= near + 1) return false;
  const double reach = kOwnReach * rod.radius;
  return std::any_of(rod.axis.begin(), rod.axis.end() - static_cast<std::ptrdiff_t>(near + 1),
                     [&](const auto& point) { return (point - rod.axis.back()).norm() < reach; });
}

// Whether images show the last segment of a rod.
bool IsEndShown(const TopologyInput& input, const Rod& rod, std::span<const ViewId> views) {
  const auto& axis = rod.axis;
  const size_t size = axis.size();
  const double turn =
      AngleBetween(axis[size - 1] - axis[size - 2], axis[size - 2] - axis[size - 3]);
  if (turn > kMaxGrowthTurnRad) return false;
  if (input.box && !input.box->contains(axis.back())) return false;
  return ShownShare(LookAlongRod(input, rod, size - 2, views, kGrownGate)) >= kMinGrownShare;
}

// Adds a segment at the end, if images show it, after a gap of at most some segments.
bool Extend(const TopologyInput& input, const ViewFinder& finder, std::span<const Rod> others,
            Rod* rod) {
  Rod longer = *rod;
  const Eigen::Vector3d step = (rod->axis.back() - rod->axis[rod->axis.size() - 2]).normalized() *
                               kAxisStepPx * rod->footprint;
  for (int gap = 0; gap <= kMaxGapSegments; ++gap) {
    longer.axis.push_back(longer.axis.back() + step);
    Rod fitted = longer;
    const std::vector<ViewId> views = finder.NearAnyOf({fitted.axis.back(), rod->axis.back()});
    FitRod(input, views, kGrowthGates, rod->axis.size() - 1, &fitted);
    if (!IsEndShown(input, fitted, views)) continue;
    if (std::ranges::any_of(others, [&](const Rod& other) {
          const Eigen::Vector3d& end = fitted.axis.back();
          return RunsAlong(other, end, end - rod->axis.back(), kBesidePx, kMaxGrowthTurnRad);
        })) {
      return false;
    }
    *rod = std::move(fitted);
    return true;
  }
  return false;
}

// Ends a rod behind the last place that images show of its last segment.
void CutEnd(const TopologyInput& input, const ViewFinder& finder, Rod* rod) {
  Eigen::Vector3d& end = rod->axis.back();
  const Eigen::Vector3d before = rod->axis[rod->axis.size() - 2];
  const std::vector<ViewId> views = finder.NearAnyOf({end});
  const auto places = LookAlongRod(input, *rod, rod->axis.size() - 2, views, kGrownGate);
  const auto last = std::find_if(places.rbegin(), places.rend(),
                                 [](const RodPlace& place) { return place.IsShown(); });
  if (last == places.rend()) return;  // a short rod that did not grow
  end = before + (last->t + 0.5 / static_cast<double>(places.size())) * (end - before);
}

}  // namespace

void GrowRod(const TopologyInput& input, const ViewFinder& finder, std::span<const Rod> others,
             Rod* rod) {
  for ([[maybe_unused]] const int end : {0, 1}) {
    std::ranges::reverse(rod->axis);
    while (rod->axis.size() < kMaxAxisPoints && !ComesBack(*rod) &&
           Extend(input, finder, others, rod)) {
    }
    CutEnd(input, finder, rod);
  }
}

}  // namespace limn
