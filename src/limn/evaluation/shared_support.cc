// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/shared_support.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/model/view_finder.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr int kPlacesOfLink = 3;
constexpr size_t kMaxLinks = 10000;
// Of the views that support a place, and of those that contain it.
constexpr size_t kMaxViews = 40;
// A view that sees a place coarser than this lacks what others see.
constexpr double kMaxCoarser = 1.5;

// At most kMaxViews of them, evenly.
std::vector<ViewId> SomeOf(const std::vector<ViewId>& views) {
  const size_t step = (views.size() + kMaxViews - 1) / kMaxViews;
  std::vector<ViewId> some;
  for (size_t i = 0; i < views.size(); i += step) some.push_back(views[i]);
  return some;
}

// The middles of as many parts of a curve, which are equally long.
Polyline3d PlacesOn(const Polyline3d& points) {
  const Polyline3d steps = ResampleUniform(points, Length(points) / (2 * kPlacesOfLink));
  Polyline3d places;
  for (size_t k = 1; k < steps.size() && places.size() < kPlacesOfLink; k += 2) {
    places.push_back(steps[k]);
  }
  return places;
}

class PairSums {
 public:
  explicit PairSums(const std::vector<View>& views) : views_(views), finder_(views) {}

  void Add(const DrawingLink& link) {
    const double footprint = LinkFootprint(link, views_);
    const double length = Length(link.points_in_world);
    if (!(footprint > 0) || !(length > 0)) return;
    std::vector<uint8_t> supports(views_.size(), 0);
    for (const ViewId v : link.supporting_views) supports[v] = 1;
    const std::vector<ViewId> from = SomeOf(link.supporting_views);
    const std::vector<ViewId> near = SomeOf(finder_.NearAnyOf(link.points_in_world));
    for (const Eigen::Vector3d& place : PlacesOn(link.points_in_world)) {
      AddPlace(place, length / kPlacesOfLink / footprint, from, near, supports);
    }
  }

  std::vector<SharedSupport> Take() const {
    std::vector<SharedSupport> pairs;
    for (const auto& [key, sum] : sums_) {
      pairs.push_back(sum);
      pairs.back().angle_deg /= sum.promised_px;
    }
    std::ranges::sort(pairs, {},
                      [](const SharedSupport& pair) { return std::pair(pair.from, pair.to); });
    return pairs;
  }

 private:
  void AddPlace(const Eigen::Vector3d& place, double px, const std::vector<ViewId>& from,
                const std::vector<ViewId>& near, const std::vector<uint8_t>& supports) {
    for (const ViewId to : near) {
      if (!views_[to].Project(place)) continue;
      const Eigen::Vector3d ray = place - views_[to].CenterInWorld();
      const auto coarse = FootprintIn(views_[to], place);
      for (const ViewId v : from) {
        const auto fine = FootprintIn(views_[v], place);
        if (v == to || !coarse || !fine || *coarse > kMaxCoarser * *fine) continue;
        SharedSupport& sum = sums_[KeyOf(v, to)];
        sum.from = v;
        sum.to = to;
        sum.promised_px += px;
        if (supports[to]) sum.shared_px += px;
        sum.angle_deg += px * AngleBetween(ray, place - views_[v].CenterInWorld()) / kDeg;
      }
    }
  }

  uint64_t KeyOf(ViewId from, ViewId to) const {
    return static_cast<uint64_t>(from) * views_.size() + static_cast<uint64_t>(to);
  }

  const std::vector<View>& views_;
  ViewFinder finder_;
  std::unordered_map<uint64_t, SharedSupport> sums_;
};

}  // namespace

std::vector<SharedSupport> MeasureSharedSupport(const std::vector<View>& views,
                                                const DrawingGraph& graph) {
  PairSums sums(views);
  const size_t step = graph.links.size() / kMaxLinks + 1;
  for (size_t l = 0; l < graph.links.size(); l += step) {
    if (graph.links[l].IsAlongEdgels()) sums.Add(graph.links[l]);
  }
  return sums.Take();
}

}  // namespace limn
