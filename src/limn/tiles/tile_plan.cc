// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "limn/model/footprint.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// A view with a smaller share of its points in a tile does not belong to it.
constexpr double kMinShare = 0.02;
// Target number of views per tile, as a share of max_views, since views at borders belong to two
// tiles.
constexpr double kFill = 0.75;
// Cutting does not help where the views of a tile have less than this share of their points in it.
constexpr double kMinMeanShare = 0.4;
constexpr size_t kMinPoints = 50;
// The plane may be moved by this share of the points to either side.
constexpr double kPlaneSlack = 0.1;
constexpr int kNumPlanes = 41;
// A point seen by this many selected views is covered.
constexpr int kEnoughViews = 20;

class TilePlanner {
 public:
  TilePlanner(const std::vector<View>& views, const SceneHints& hints, const TileOptions& options)
      : points_(hints.points), options_(options), num_points_(views.size(), 0) {
    for (const ScenePoint& point : points_) {
      for (const ViewId v : point.views) ++num_points_[v];
      footprints_.push_back(MedianFootprint(point.position_in_world, point.views, views));
    }
    for (const ScenePoint& point : points_) {
      double weight = 0;
      for (const ViewId v : point.views) weight += 1.0 / num_points_[v];
      weights_.push_back(weight);
    }
  }

  // Empty if there are hardly any points to cut by.
  std::vector<Tile> Plan(const Eigen::AlignedBox3d& box) {
    std::vector<int> all(points_.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<int> near = In(box, all);
    if (near.size() >= kMinPoints) Cut(AllSpace(), box, near);
    return std::move(tiles_);
  }

 private:
  // `near` contains all points of the reach.
  void Cut(const Eigen::AlignedBox3d& core, const Eigen::AlignedBox3d& widest_reach,
           const std::vector<int>& near) {
    const std::vector<int> inside = In(core, near);
    const double margin = options_.reach_px * FootprintOf(inside.empty() ? near : inside);
    Eigen::AlignedBox3d reach(core.min().array() - margin, core.max().array() + margin);
    reach = reach.intersection(widest_reach);
    const std::vector<int> reached = In(reach, near);
    const double weight = WeightOf(reached);
    const int num_views = static_cast<int>(ViewsOf(reached).size());
    if (num_views <= options_.max_views || inside.size() < kMinPoints ||
        weight < kMinMeanShare * options_.max_views) {
      return AddTile(core, reach, reached);
    }
    int axis = 0;
    const double extent = LongestExtent(inside, &axis);
    const double num_parts = std::max(std::ceil(weight / (kFill * options_.max_views)), 2.0);
    const double share = std::floor(num_parts / 2) / num_parts;
    const double plane = PlaneAt(inside, axis, share, margin / 8);
    const bool is_inside = core.min()[axis] < plane && plane < core.max()[axis];
    if (extent < 4 * margin || !is_inside) return AddTile(core, reach, reached);
    Eigen::AlignedBox3d below = core, above = core;
    below.max()[axis] = above.min()[axis] = plane;
    Cut(below, reach, reached);
    Cut(above, reach, reached);
  }

  std::vector<int> In(const Eigen::AlignedBox3d& box, const std::vector<int>& points) const {
    std::vector<int> inside;
    for (const int p : points) {
      if (box.contains(points_[p].position_in_world)) inside.push_back(p);
    }
    return inside;
  }

  double FootprintOf(const std::vector<int>& points) const {
    std::vector<double> footprints;
    for (const int p : points) footprints.push_back(footprints_[p]);
    return Median(std::move(footprints));
  }

  std::vector<int> CountByView(const std::vector<int>& points) const {
    std::vector<int> counts(num_points_.size(), 0);
    for (const int p : points) {
      for (const ViewId v : points_[p].views) ++counts[v];
    }
    return counts;
  }

  // Number of views, each counted by its share of points among these.
  double WeightOf(const std::vector<int>& points) const {
    double weight = 0;
    const std::vector<int> counts = CountByView(points);
    for (size_t v = 0; v < counts.size(); ++v) {
      if (counts[v] > 0) weight += static_cast<double>(counts[v]) / num_points_[v];
    }
    return weight;
  }

  std::vector<ViewId> ViewsOf(const std::vector<int>& points) const {
    std::vector<ViewId> views;
    const std::vector<int> counts = CountByView(points);
    for (size_t v = 0; v < counts.size(); ++v) {
      if (counts[v] > kMinShare * num_points_[v]) views.push_back(static_cast<ViewId>(v));
    }
    return views;
  }

  // The places of points along an axis, ascending, each with the weight of the points up to it.
  struct Places {
    std::vector<double> at;
    std::vector<double> weight;

    // The place below which this share of the weight lies.
    double Quantile(double share) const {
      const auto it = std::lower_bound(weight.begin(), weight.end(), share * weight.back());
      return at[std::min<size_t>(it - weight.begin(), at.size() - 1)];
    }
  };

  Places PlacesAlong(const std::vector<int>& points, int axis) const {
    std::vector<std::pair<double, double>> sorted;
    for (const int p : points) {
      sorted.push_back({points_[p].position_in_world[axis], weights_[p]});
    }
    std::sort(sorted.begin(), sorted.end());
    Places places;
    double sum = 0;
    for (const auto& [at, weight] : sorted) {
      places.at.push_back(at);
      places.weight.push_back(sum += weight);
    }
    return places;
  }

  // Extent of nearly all points, by weight.
  double LongestExtent(const std::vector<int>& points, int* longest_axis) const {
    double longest = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const Places places = PlacesAlong(points, axis);
      const double extent = places.Quantile(0.95) - places.Quantile(0.05);
      if (extent > longest) {
        longest = extent;
        *longest_axis = axis;
      }
    }
    return longest;
  }

  // A place near this quantile with few points within `width`.
  double PlaneAt(const std::vector<int>& points, int axis, double share, double width) const {
    const Places places = PlacesAlong(points, axis);
    const double low = places.Quantile(share - kPlaneSlack);
    const double high = places.Quantile(share + kPlaneSlack);
    double best = low;
    auto fewest = std::numeric_limits<std::ptrdiff_t>::max();
    for (int i = 0; i < kNumPlanes; ++i) {
      const double place = low + (high - low) * i / (kNumPlanes - 1);
      const auto count = std::upper_bound(places.at.begin(), places.at.end(), place + width) -
                         std::lower_bound(places.at.begin(), places.at.end(), place - width);
      if (count < fewest) {
        fewest = count;
        best = place;
      }
    }
    return best;
  }

  // Greedy choice of as many views as allowed: always the one that sees most points not yet
  // covered.
  std::vector<ViewId> Choose(const std::vector<ViewId>& views,
                             const std::vector<int>& points) const {
    std::vector<int> times_seen(points_.size(), 0);
    std::vector<uint8_t> left(num_points_.size(), 0);
    for (const ViewId v : views) left[v] = 1;
    std::vector<ViewId> chosen;
    while (static_cast<int>(chosen.size()) < options_.max_views) {
      std::vector<int> gains(num_points_.size(), 0);
      for (const int p : points) {
        if (times_seen[p] >= kEnoughViews) continue;
        for (const ViewId v : points_[p].views) gains[v] += left[v];
      }
      const auto best = std::max_element(gains.begin(), gains.end());
      if (*best == 0) break;
      chosen.push_back(static_cast<ViewId>(best - gains.begin()));
      left[chosen.back()] = 0;
      for (const int p : points) {
        times_seen[p] +=
            std::binary_search(points_[p].views.begin(), points_[p].views.end(), chosen.back());
      }
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

  void AddTile(const Eigen::AlignedBox3d& core, const Eigen::AlignedBox3d& reach,
               const std::vector<int>& reached) {
    Tile tile{core, reach, ViewsOf(reached)};
    if (static_cast<int>(tile.views.size()) > options_.max_views) {
      tile.views = Choose(tile.views, reached);
    }
    tiles_.push_back(std::move(tile));
  }

  const std::vector<ScenePoint>& points_;
  const TileOptions& options_;
  std::vector<int> num_points_;     // per view
  std::vector<double> footprints_;  // per point; 0 = not seen
  std::vector<double> weights_;     // per point: the views that see it, by their share of points
  std::vector<Tile> tiles_;
};

}  // namespace

Eigen::AlignedBox3d AllSpace() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity)};
}

std::vector<Tile> PlanTiles(const std::vector<View>& views, const SceneHints& hints,
                            const std::optional<Eigen::AlignedBox3d>& box,
                            const TileOptions& options) {
  options.Check();
  const Eigen::AlignedBox3d space = box.value_or(AllSpace());
  const auto num_views = static_cast<int>(views.size());
  std::vector<Tile> tiles;
  if (options.max_views > 0 && num_views > options.max_views) {
    tiles = TilePlanner(views, hints, options).Plan(space);
  }
  if (!tiles.empty()) return tiles;
  std::vector<ViewId> all(views.size());
  std::iota(all.begin(), all.end(), 0);
  return {{AllSpace(), space, std::move(all)}};
}

bool IsInTiles(const std::vector<Tile>& tiles, const std::vector<View>& views) {
  return tiles.size() > 1 || tiles.front().views.size() < views.size();
}

}  // namespace limn
