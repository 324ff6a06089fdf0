// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/rod_sights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "limn/model/footprint.h"

namespace limn {
namespace {

constexpr double kPlaceStepPx = 2;
// Standard deviation of the blur of an edge, of lens, pixels and detector, px.
constexpr double kBlurPx = 1.2;

// The edgels at a place of an outline, by whether the outside is the brighter side.
using OutlineEdgels = std::array<std::optional<EdgelMatch>, 2>;

// `outward`: in the image, away from the axis.
OutlineEdgels FindOutline(const EdgelIndex& edgels, const CurveSight& sight,
                          const Eigen::Vector2d& outward, const SupportGate& gate) {
  // Edgels that point in this direction are brighter on the side opposite to Across().
  const bool is_across = sight.Across().dot(outward) > 0;
  const Eigen::Vector2d bright_outside = is_across ? -sight.direction : sight.direction;
  return {edgels.BestAlong(sight.position_px, -bright_outside, gate),
          edgels.BestAlong(sight.position_px, bright_outside, gate)};
}

std::optional<RodSight> SightOf(const TopologyInput& input, const RodPlace& place, double radius,
                                ViewId v, const SupportGate& gate) {
  const View& view = input.views[v];
  const auto footprint = FootprintIn(view, place.position);
  if (!footprint) return std::nullopt;
  const double seen = SeenHalfWidth(radius / *footprint) * *footprint;
  const Eigen::Vector3d across =
      place.tangent.cross(place.position - view.CenterInWorld()).normalized();
  const auto first = See(view, place.position + seen * across, place.tangent);
  const auto second = See(view, place.position - seen * across, place.tangent);
  if (!first || !second) return std::nullopt;
  const Eigen::Vector2d outward = first->position_px - second->position_px;
  const EdgelIndex& edgels = input.edgels[v]->edgels;
  const OutlineEdgels at_first = FindOutline(edgels, *first, outward, gate);
  const OutlineEdgels at_second = FindOutline(edgels, *second, -outward, gate);
  std::optional<RodSight> nearest;
  double nearest_px = std::numeric_limits<double>::infinity();
  for (const int is_bright : {0, 1}) {
    const auto& a = at_first[is_bright];
    const auto& b = at_second[is_bright];
    if (!a || !b) continue;
    const double distance_px = std::abs(a->normal_residual_px) + std::abs(b->normal_residual_px);
    if (distance_px >= nearest_px) continue;
    nearest_px = distance_px;
    nearest = RodSight{v,
                       across,
                       {EdgelRef{v, a->edgel}, EdgelRef{v, b->edgel}},
                       seen,
                       std::pow(radius / seen, 3)};
  }
  return nearest;
}

}  // namespace

double SeenHalfWidth(double half_width_px) {
  return std::pow(std::pow(half_width_px, 4) + std::pow(kBlurPx, 4), 0.25);
}

std::vector<RodPlace> LookAlongRod(const TopologyInput& input, const Rod& rod, size_t first,
                                   std::span<const ViewId> views, const SupportGate& gate) {
  std::vector<RodPlace> places;
  for (size_t s = first; s + 1 < rod.axis.size(); ++s) {
    const Eigen::Vector3d way = rod.axis[s + 1] - rod.axis[s];
    const int count =
        std::max(1, static_cast<int>(std::lround(way.norm() / (kPlaceStepPx * rod.footprint))));
    for (int k = 0; k < count; ++k) {
      RodPlace place;
      place.segment = static_cast<int>(s);
      place.t = (k + 0.5) / count;
      place.position = rod.axis[s] + place.t * way;
      place.tangent = way.normalized();
      for (const ViewId v : views) {
        if (const auto sight = SightOf(input, place, rod.radius, v, gate)) {
          place.sights.push_back(*sight);
        }
      }
      places.push_back(std::move(place));
    }
  }
  return places;
}

double ShownShare(std::span<const RodPlace> places) {
  const auto num_shown = std::ranges::count_if(places, &RodPlace::IsShown);
  return places.empty() ? 0 : static_cast<double>(num_shown) / static_cast<double>(places.size());
}

}  // namespace limn
