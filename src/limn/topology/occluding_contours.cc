#include "limn/topology/occluding_contours.h"

#include <algorithm>
#include <cmath>

#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Support is narrow if its viewing directions span less than this share of the span of all views.
constexpr double kNarrowShare = 0.5;
// Views within this angle of a supporting one show where the outline moved, by at most this far,
// virtual px.
constexpr double kBesideRad = 20 * kDeg;
constexpr double kMaxShiftPx = 10;
// The edgel of a moved outline keeps its direction, and lies beside the point.
constexpr double kSameDirectionRad = 12 * kDeg;
constexpr double kMaxAlongPx = 1.5;
// Share of those views, net, that must show the outline on the same side.
constexpr double kOneSidedShare = 0.5;

// A view that contains a point of a link.
struct Sight {
  ViewId view = -1;
  Eigen::Vector2d pixel;
  Eigen::Vector2d along;  // unit direction of the link in the image
  Eigen::Vector3d ray;    // unit, from the camera, without its part along the link
};

// Largest angle between two of the rays.
double Spread(const std::vector<Sight>& sights) {
  double smallest_cosine = 1;
  for (size_t i = 0; i < sights.size(); ++i) {
    for (size_t j = i + 1; j < sights.size(); ++j) {
      smallest_cosine = std::min(smallest_cosine, sights[i].ray.dot(sights[j].ray));
    }
  }
  return std::acos(std::max(smallest_cosine, -1.0));
}

bool IsBeside(const Sight& sight, const std::vector<Sight>& supporting) {
  return std::any_of(supporting.begin(), supporting.end(), [&](const Sight& other) {
    return sight.ray.dot(other.ray) > std::cos(kBesideRad);
  });
}

// Side of the point on which the nearest edgel of the same polarity lies: 1 or -1, 0 if there is
// none.
int SideOfNearest(const TopologyInput& input, const Sight& sight, int polarity) {
  const Eigen::Vector2d across(-sight.along.y(), sight.along.x());
  double nearest = kMaxShiftPx;
  int side = 0;
  input.edgels[sight.view]->edgels.ForEachWithin(sight.pixel, kMaxShiftPx, [&](EdgelId id) {
    const Edgel& edgel = input.EdgelOf({sight.view, id});
    const Eigen::Vector2d offset = edgel.position_px - sight.pixel;
    const double cosine = sight.along.dot(edgel.Tangent());
    if (std::abs(offset.dot(sight.along)) > kMaxAlongPx || cosine * polarity <= 0 ||
        std::abs(cosine) < std::cos(kSameDirectionRad)) {
      return;
    }
    const double shift = offset.dot(across);
    if (std::abs(shift) >= nearest) return;
    nearest = std::abs(shift);
    side = shift > 0 ? 1 : -1;
  });
  return side;
}

// Both signs of a contour, summed over the points of a link.
struct Signs {
  double supported_spread = 0;
  double whole_spread = 0;
  int num_beside = 0;
  int side = 0;
};

void AddPoint(const TopologyInput& input, const std::vector<ViewId>& near,
              const Eigen::Vector3d& point, const Eigen::Vector3d& tangent, Signs* signs) {
  std::vector<Sight> all;
  std::vector<Sight> supporting;
  std::vector<Sight> others;
  int polarity = 0;  // in how many more supporting views it is brighter to the left than right
  for (const ViewId v : near) {
    const auto sight = See(input.views[v], point, tangent);
    if (!sight) continue;
    const auto& [pixel, direction] = *sight;
    const Eigen::Vector3d ray = point - input.views[v].CenterInWorld();
    all.push_back({v, pixel, direction, (ray - ray.dot(tangent) * tangent).stableNormalized()});
    const auto match = input.edgels[v]->edgels.Best(pixel, direction, input.gate);
    (match ? supporting : others).push_back(all.back());
    if (!match) continue;
    const Eigen::Vector2d bright_left = input.EdgelOf({v, match->edgel}).Tangent();
    polarity += all.back().along.dot(bright_left) > 0 ? 1 : -1;
  }
  signs->supported_spread += Spread(supporting);
  signs->whole_spread += Spread(all);
  for (const Sight& sight : others) {
    if (!IsBeside(sight, supporting)) continue;
    ++signs->num_beside;
    signs->side += SideOfNearest(input, sight, polarity);
  }
}

}  // namespace

std::optional<double> ContourConfidence(const TopologyInput& input, const DrawingLink& link,
                                        const std::vector<ViewId>& near) {
  Signs signs;
  const std::vector<int> probes = ProbePoints(link);
  for (const int k : probes) {
    AddPoint(input, near, link.points_in_world[k], TangentAt(link, k), &signs);
  }
  const int num_net = std::abs(signs.side);
  if (signs.supported_spread >= kNarrowShare * signs.whole_spread ||
      num_net <= kOneSidedShare * signs.num_beside) {
    return std::nullopt;
  }
  // Points of one link see the same outline: their mean counts once.
  const auto num_points = static_cast<double>(probes.size());
  const double num_views = signs.num_beside / num_points;
  const double num_same_side = 0.5 * (num_views + num_net / num_points);
  return (num_same_side + 1) / (num_views + 2);
}

}  // namespace limn
