#include "limn/topology/occluding_contours.h"

#include <algorithm>
#include <cmath>

#include "limn/support/edgel_residual.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// The thresholds were chosen on midday, mixed light, vase and day. At most this many points of a
// link are tested.
constexpr int kMaxProbes = 60;
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
  double direction = 0;  // of the link, in the image
  Eigen::Vector3d ray;   // unit, from the camera, without its part along the link
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

// Accumulates both signs over the points of a link.
class ContourTest {
 public:
  ContourTest(const TopologyInput& input, const std::vector<ViewId>& near)
      : input_(input), near_(near) {}

  void Add(const Eigen::Vector3d& point, const Eigen::Vector3d& tangent) {
    std::vector<Sight> all;
    std::vector<Sight> supporting;
    std::vector<Sight> others;
    int polarity = 0;  // in how many more supporting views it is brighter to the left than right
    for (const ViewId v : near_) {
      const auto sight = See(input_.views[v], point, tangent);
      if (!sight) continue;
      const Eigen::Vector3d ray = point - input_.views[v].CenterInWorld();
      all.push_back({v, sight->position_px, sight->direction_rad,
                     (ray - ray.dot(tangent) * tangent).stableNormalized()});
      const auto match =
          input_.edgels[v]->edgels.Best(sight->position_px, sight->direction_rad, input_.gate);
      (match ? supporting : others).push_back(all.back());
      if (match) polarity += AlongDirection(all.back(), match->edgel) > 0 ? 1 : -1;
    }
    supported_spread_ += Spread(supporting);
    whole_spread_ += Spread(all);
    for (const Sight& sight : others) {
      if (!IsBeside(sight, supporting)) continue;
      ++num_beside_;
      side_ += SideOfNearest(sight, polarity);
    }
  }

  bool IsOccludingContour() const {
    return supported_spread_ < kNarrowShare * whole_spread_ &&
           std::abs(side_) > kOneSidedShare * num_beside_;
  }

 private:
  // Cosine of the angle between the link and an edgel, whose brighter side is on its left.
  double AlongDirection(const Sight& sight, EdgelId id) const {
    const Eigen::Vector2d along(std::cos(sight.direction), std::sin(sight.direction));
    return along.dot(input_.curves[sight.view].edge_map.edgels[id].Tangent());
  }

  static bool IsBeside(const Sight& sight, const std::vector<Sight>& supporting) {
    return std::any_of(supporting.begin(), supporting.end(), [&](const Sight& other) {
      return sight.ray.dot(other.ray) > std::cos(kBesideRad);
    });
  }

  // Side of the point on which the nearest edgel of the same polarity lies: 1 or -1, 0 if there is
  // none.
  int SideOfNearest(const Sight& sight, int polarity) const {
    const Eigen::Vector2d along(std::cos(sight.direction), std::sin(sight.direction));
    const Eigen::Vector2d across(-along.y(), along.x());
    double nearest = kMaxShiftPx;
    int side = 0;
    input_.edgels[sight.view]->edgels.ForEachWithin(sight.pixel, kMaxShiftPx, [&](EdgelId id) {
      const Eigen::Vector2d offset =
          input_.curves[sight.view].edge_map.edgels[id].position_px - sight.pixel;
      const double cosine = AlongDirection(sight, id);
      if (std::abs(offset.dot(along)) > kMaxAlongPx || cosine * polarity <= 0 ||
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

  const TopologyInput& input_;
  const std::vector<ViewId>& near_;
  double supported_spread_ = 0;
  double whole_spread_ = 0;
  int num_beside_ = 0;
  int side_ = 0;
};

}  // namespace

bool IsOccludingContour(const TopologyInput& input, const DrawingLink& link,
                        const std::vector<ViewId>& near) {
  ContourTest test(input, near);
  for (const int k : ProbePoints(link, kMaxProbes)) {
    test.Add(link.points_in_world[k], TangentAt(link, k));
  }
  return test.IsOccludingContour();
}

}  // namespace limn
