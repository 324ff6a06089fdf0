// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/split_corners.h"

#include <algorithm>
#include <cmath>

#include "limn/geometry/angle_between.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// The arms of a corner, px from it. Nearer points are rounded by the smoothing.
constexpr int kArmBeginPx = 3;
constexpr int kArmMiddlePx = 7;
constexpr int kArmEndPx = 11;
// Smallest turn from arm to arm, rad, and the largest share of it that may lie within an arm. On a
// circle that share is a quarter.
constexpr double kMinCornerRad = 0.6;
constexpr double kMaxArmShare = 0.15;
// Smallest distance between corners of a link, px.
constexpr int kApartPx = 8;

bool IsCorner(const std::vector<Eigen::Vector3d>& points, int k) {
  if (k < kArmEndPx || k + kArmEndPx >= static_cast<int>(points.size())) return false;
  const auto turn = [&](int a, int b, int c, int d) {
    return TurnBetween((points[k + b] - points[k + a]).normalized(),
                       (points[k + d] - points[k + c]).normalized());
  };
  const double whole = turn(-kArmEndPx, -kArmBeginPx, kArmBeginPx, kArmEndPx);
  if (whole < kMinCornerRad) return false;
  const double before = turn(-kArmEndPx, -kArmMiddlePx, -kArmMiddlePx, -kArmBeginPx);
  const double after = turn(kArmBeginPx, kArmMiddlePx, kArmMiddlePx, kArmEndPx);
  return std::max(before, after) < kMaxArmShare * whole;
}

// Returns indices in descending order.
std::vector<int> FindCorners(const std::vector<Eigen::Vector3d>& points) {
  // How far a point sticks out.
  const auto height_at = [&](int k) {
    return (points[k] - 0.5 * (points[k - kArmBeginPx] + points[k + kArmBeginPx])).norm();
  };
  std::vector<std::pair<double, int>> sharpest_first;
  for (int k = 0; k < static_cast<int>(points.size()); ++k) {
    // Near an end, the arms do not fit around the corner itself, only around points beside it.
    if (!IsCorner(points, k) || height_at(k) < std::max(height_at(k - 1), height_at(k + 1)))
      continue;
    sharpest_first.push_back({-height_at(k), k});
  }
  std::sort(sharpest_first.begin(), sharpest_first.end());
  std::vector<int> corners;
  for (const auto& sharpest : sharpest_first) {
    const int k = sharpest.second;
    const bool apart = std::all_of(corners.begin(), corners.end(),
                                   [&](int other) { return std::abs(other - k) >= kApartPx; });
    if (apart) corners.push_back(k);
  }
  std::sort(corners.rbegin(), corners.rend());
  return corners;
}

}  // namespace

int64_t SplitAtCorners(GraphEditor* editor) {
  int64_t num_corners = 0;
  const LinkId num_links = editor->NumLinks();
  for (LinkId id = 0; id < num_links; ++id) {
    if (editor->link(id).closed || editor->link(id).vertices.empty()) continue;
    for (const int index : FindCorners(editor->link(id).points_in_world)) {
      editor->Split(id, index);
      ++num_corners;
    }
  }
  return num_corners;
}

}  // namespace limn
