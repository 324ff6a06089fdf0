// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/rod_seeds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"
#include "limn/model/link_selection.h"
#include "limn/rods/rod_limits.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"
#include "limn/util/median.h"

namespace limn {
namespace {

constexpr double kSpacingPx = 2;
// How far apart links of a pair are, px: two outlines that were reconstructed from views on one
// side of a rod are nearer to each other than its thickness.
constexpr double kMinApartPx = 1;
constexpr double kMaxApartPx = 2 * kMaxRadiusPx + 1;
constexpr double kMaxTurnRad = 15 * kDeg;
constexpr int kMinRun = 7;  // places

struct LinkPlace {
  LinkId link = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();
  double footprint = 0;
};

// Places of the links that may be outlines, link by link.
std::vector<LinkPlace> PlacesOf(const std::vector<View>& views, const DrawingGraph& graph) {
  const LinkSelection selection;
  std::vector<LinkPlace> places;
  for (LinkId id = 0; id < std::ssize(graph.links); ++id) {
    const DrawingLink& link = graph.links[id];
    const double footprint = LinkFootprint(link, views);
    if (!selection.Has(link) || !(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, kSpacingPx * footprint);
    for (size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d way =
          points[std::min(k + 1, points.size() - 1)] - points[k == 0 ? 0 : k - 1];
      places.push_back({id, points[k], way.normalized(), footprint});
    }
  }
  return places;
}

// The longest run of places of one link beside another link.
struct Run {
  std::vector<Eigen::Vector3d> middles;
  std::vector<double> distances;
};

void KeepLonger(Run run, Run* longest) {
  if (run.middles.size() > longest->middles.size()) *longest = std::move(run);
}

class SeedFinder {
 public:
  SeedFinder(const std::vector<View>& views, const DrawingGraph& graph)
      : graph_(graph), places_(PlacesOf(views, graph)), index_(Positions(places_)) {
    for (size_t p = 0; p < places_.size(); ++p) {
      if (p == 0 || places_[p].link != places_[p - 1].link) first_.push_back(p);
    }
    first_.push_back(places_.size());
  }

  size_t NumLinks() const { return first_.size() - 1; }

  // Of the n-th link and those after it.
  std::vector<RodSeed> SeedsOf(size_t n) const {
    std::map<LinkId, Run> longest;
    std::map<LinkId, Run> current;
    std::vector<RodSeed> seeds;
    const LinkPlace& begin = places_[first_[n]];
    for (size_t p = first_[n]; p < first_[n + 1]; ++p) {
      std::map<LinkId, Run> next;
      for (const auto& [other, place] : Beside(p)) {
        Run& run = next[other];
        if (const auto before = current.find(other); before != current.end()) {
          run = std::move(before->second);
        }
        run.middles.push_back((places_[p].position + place->position) / 2);
        run.distances.push_back((places_[p].position - place->position).norm());
      }
      for (auto& [other, run] : current) KeepLonger(std::move(run), &longest[other]);
      current = std::move(next);
    }
    for (auto& [other, run] : current) KeepLonger(std::move(run), &longest[other]);
    for (const auto& [other, run] : longest) {
      if (std::ssize(run.middles) < kMinRun) continue;
      seeds.push_back({RodFrom(run, begin.footprint), ViewsOfEither(begin.link, other)});
    }
    return seeds;
  }

 private:
  static std::vector<Eigen::Vector3d> Positions(const std::vector<LinkPlace>& places) {
    std::vector<Eigen::Vector3d> positions;
    for (const LinkPlace& place : places) positions.push_back(place.position);
    return positions;
  }

  // The nearest places of later links beside a place.
  std::map<LinkId, const LinkPlace*> Beside(size_t p) const {
    const LinkPlace& place = places_[p];
    std::map<LinkId, const LinkPlace*> beside;
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(place.position, kMaxApartPx * place.footprint, &near);
    std::map<LinkId, double> distance;
    for (const SpatialIndex::Neighbor& neighbor : near) {
      const LinkPlace& other = places_[neighbor.index];
      if (other.link <= place.link) continue;
      const auto [known, is_new] = distance.emplace(other.link, neighbor.squared_distance);
      if (!is_new && neighbor.squared_distance >= known->second) continue;
      known->second = neighbor.squared_distance;
      beside[other.link] = &other;
    }
    std::erase_if(beside, [&](const auto& item) {
      const LinkPlace& other = *item.second;
      return (other.position - place.position).norm() < kMinApartPx * place.footprint ||
             LineAngleBetween(other.tangent, place.tangent) > kMaxTurnRad;
    });
    return beside;
  }

  std::vector<ViewId> ViewsOfEither(LinkId a, LinkId b) const {
    std::vector<ViewId> views;
    std::ranges::set_union(graph_.links[a].supporting_views, graph_.links[b].supporting_views,
                           std::back_inserter(views));
    return views;
  }

  static Rod RodFrom(const Run& run, double footprint) {
    return {ResampleUniform(run.middles, kAxisStepPx * footprint), Median(run.distances) / 2,
            footprint};
  }

  const DrawingGraph& graph_;
  std::vector<LinkPlace> places_;
  std::vector<size_t> first_;  // place of each link, and the number of places
  SpatialIndex index_;
};

}  // namespace

std::vector<RodSeed> FindRodSeeds(const std::vector<View>& views, const DrawingGraph& graph,
                                  const RunContext& context) {
  const SeedFinder finder(views, graph);
  const auto of_link = MapItems(context, "pairs of links", finder.NumLinks(),
                                [&](size_t n) { return finder.SeedsOf(n); });
  std::vector<RodSeed> seeds;
  for (const std::vector<RodSeed>& of_one : of_link) {
    seeds.insert(seeds.end(), of_one.begin(), of_one.end());
  }
  return seeds;
}

}  // namespace limn
