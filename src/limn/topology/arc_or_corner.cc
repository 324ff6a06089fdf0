// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/arc_or_corner.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "limn/geometry/angle_between.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// The direction of an end, and the views that show it, are those of this much of it, px.
constexpr double kArcTipPx = 4;
// Edge detectors round corners by this much, px: a corner nearer to the arc is one.
constexpr double kRoundingPx = 1;
constexpr double kMaxArcTurnRad = 150 * kDeg;
constexpr SupportGate kWayGate = {0.75, 1.0, 20 * kDeg};
// Points where ways are compared, px apart.
constexpr double kWayStepPx = 0.5;
// By how much more of the arc than of the corner edgels must be shown.
constexpr double kMinArcGain = 0.1;
constexpr double kArcPointsPx = 1;

struct Tip {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
  double footprint = 0;
};

Tip LocalTip(const DrawingLink& link, int end, std::vector<ViewId>* views) {
  const int size = link.size();
  const auto index = [&](int k) { return end == 0 ? k : size - 1 - k; };
  Tip tip;
  tip.point = EndPoint(link, end);
  tip.footprint = link.vertices[index(0)].footprint;
  for (int k = 0; k < size; ++k) {
    const Eigen::Vector3d way = tip.point - link.points_in_world[index(k)];
    for (const EdgelRef& ref : link.vertices[index(k)].support) views->push_back(ref.view);
    if (way.norm() < kArcTipPx * tip.footprint) continue;
    tip.outward = way.normalized();
    break;
  }
  return tip;
}

// A cubic that leaves and arrives in the directions of both tips, near to an arc between them.
Polyline3d SmoothWay(const Tip& a, const Tip& b, double step) {
  const double chord = (b.point - a.point).norm();
  const double turn = AngleBetween(a.outward, -b.outward);
  const double handle =
      turn > 1e-3 ? 2.0 / 3 * chord * std::tan(turn / 4) / std::sin(turn / 2) : chord / 3;
  const Eigen::Vector3d from = a.point + handle * a.outward;
  const Eigen::Vector3d to = b.point + handle * b.outward;
  const int count = std::max(2, static_cast<int>(std::ceil((chord + 2 * handle) / step)));
  Polyline3d way;
  for (int k = 0; k <= count; ++k) {
    const double t = static_cast<double>(k) / count;
    const double s = 1 - t;
    way.push_back(s * s * s * a.point + 3 * s * s * t * from + 3 * s * t * t * to +
                  t * t * t * b.point);
  }
  return way;
}

// Share of the places along a way, in the views that have them, where edgels run along it.
double ShownAlong(const TopologyInput& input, const Polyline3d& way, double step,
                  std::span<const ViewId> views) {
  const Polyline3d places = ResampleUniform(way, step);
  int count = 0;
  int shown = 0;
  for (size_t k = 0; k + 1 < places.size(); ++k) {
    const Eigen::Vector3d middle = (places[k] + places[k + 1]) / 2;
    for (const ViewId v : views) {
      const auto sight = See(input.views[v], middle, places[k + 1] - places[k]);
      if (!sight) continue;
      ++count;
      shown +=
          input.edgels[v]->edgels.Best(sight->position_px, sight->direction, kWayGate).has_value();
    }
  }
  return count > 0 ? static_cast<double>(shown) / count : 0;
}

}  // namespace

std::optional<Polyline3d> ArcInsteadOfCorner(const TopologyInput& input, const GraphEditor& editor,
                                             const LinkEnd& a, const LinkEnd& b,
                                             const Eigen::Vector3d& corner) {
  std::vector<ViewId> views;
  const Tip tip_a = LocalTip(editor.link(a.link), a.end, &views);
  const Tip tip_b = LocalTip(editor.link(b.link), b.end, &views);
  SortUnique(&views);
  if (tip_a.outward.isZero() || tip_b.outward.isZero()) return std::nullopt;
  const double px = tip_a.footprint;
  if (AngleBetween(tip_a.outward, -tip_b.outward) > kMaxArcTurnRad) return std::nullopt;
  const Polyline3d arc = SmoothWay(tip_a, tip_b, kArcPointsPx * px);
  const double past_px = std::sqrt(ClosestPoint(arc, corner).squared_distance) / px;
  if (past_px < kRoundingPx) return std::nullopt;
  const double of_arc = ShownAlong(input, arc, kWayStepPx * px, views);
  const double of_corner =
      ShownAlong(input, {tip_a.point, corner, tip_b.point}, kWayStepPx * px, views);
  if (of_arc < of_corner + kMinArcGain) return std::nullopt;
  return arc;
}

}  // namespace limn
