// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/side_edges.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "limn/topology/edgel_claims.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/runs.h"
#include "limn/util/sort_unique.h"

namespace limn {
namespace {

// Shortest run of edgels without a link, px, and the length over which its direction is measured.
constexpr double kMinRunPx = 3;
constexpr double kDirectionPx = 4;
// How far ahead of its end and behind it the line of a run may meet a link's edgel, and how far
// from the edgel, px.
constexpr double kMaxAheadPx = 5;
constexpr double kMaxBehindPx = 2;
constexpr double kMaxBesidePx = 1.5;
// Smallest angle between the run and the link.
constexpr double kMinAngleRad = 25 * kDeg;
// Places of a link within this length, px, are one, and this many views must show it. Fewer views
// cut more links without need.
constexpr double kClusterPx = 2;
constexpr int kMinSideViews = 4;
// Nodes are not made nearer than this to the ends of a link, px.
constexpr double kFromEndPx = 5;

// Finds the points of links at which runs of a view's edgels end.
class RunEnds {
 public:
  RunEnds(const TopologyInput& input, const std::vector<LinkPoint>& claims, ViewId view)
      : claims_(claims),
        edgels_(input.curves[view].edge_map.edgels),
        index_(input.edgels[view]->edgels),
        fragments_(input.curves[view].fragments) {}

  std::vector<LinkPoint> Find() {
    for (const CurveFragment& fragment : fragments_) {
      ForEachRun(
          static_cast<int>(fragment.edgel_ids.size()),
          [&](int i) { return !IsClaimed(fragment, i, claims_); },
          [&](int begin, int end) { AddRun(fragment, begin, end); });
    }
    SortUnique(&found_);
    return std::move(found_);
  }

 private:
  const Eigen::Vector2d& At(const CurveFragment& fragment, int i) const {
    return edgels_[fragment.edgel_ids[i]].position_px;
  }

  void AddRun(const CurveFragment& fragment, int begin, int end) {
    if ((At(fragment, end - 1) - At(fragment, begin)).norm() < kMinRunPx) return;
    AddEnd(fragment, begin, end - 1, 1);
    AddEnd(fragment, end - 1, begin, -1);
  }

  void AddEnd(const CurveFragment& fragment, int tip, int far, int step) {
    const Eigen::Vector2d& place = At(fragment, tip);
    int inside = tip;
    while (inside != far && (At(fragment, inside) - place).norm() < kDirectionPx) inside += step;
    const Eigen::Vector2d outward = (place - At(fragment, inside)).normalized();
    double nearest_px = kMaxAheadPx;
    LinkPoint met;
    index_.ForEachWithin(place, kMaxAheadPx + 1, [&](EdgelId id) {
      if (claims_[id].link < 0) return;
      const Edgel& edgel = edgels_[id];
      const double sine = std::abs(edgel.Normal().dot(outward));
      if (sine < std::sin(kMinAngleRad)) return;
      const Eigen::Vector2d offset = edgel.position_px - place;
      const double ahead_px = edgel.Normal().dot(offset) / edgel.Normal().dot(outward);
      const double beside_px = std::abs(edgel.Tangent().dot(offset - ahead_px * outward));
      if (ahead_px < -kMaxBehindPx || ahead_px >= nearest_px || beside_px > kMaxBesidePx) {
        return;
      }
      nearest_px = ahead_px;
      met = claims_[id];
    });
    if (met.link >= 0) found_.push_back(met);
  }

  const std::vector<LinkPoint>& claims_;
  const std::vector<Edgel>& edgels_;
  const EdgelIndex& index_;
  const std::vector<CurveFragment>& fragments_;
  std::vector<LinkPoint> found_;
};

// The points at which to split a link, descending. `seen` holds (index, view), ascending.
std::vector<int> ChooseCuts(const DrawingLink& link,
                            const std::vector<std::pair<int, ViewId>>& seen) {
  std::vector<double> arc_px = {0};
  for (int k = 1; k < link.size(); ++k) arc_px.push_back(arc_px.back() + ArcPx(link, k - 1, k));
  std::vector<std::pair<int, int>> places;  // minus the number of views, index
  for (size_t i = 0; i < seen.size(); ++i) {
    const int center = seen[i].first;
    if (i > 0 && seen[i - 1].first == center) continue;
    if (std::min(arc_px[center], arc_px.back() - arc_px[center]) < kFromEndPx) continue;
    std::vector<ViewId> views;
    const auto is_before = [&](const std::pair<int, ViewId>& other) {
      return arc_px[center] - arc_px[other.first] > kClusterPx;
    };
    for (auto other = std::ranges::partition_point(seen, is_before);
         other != seen.end() && arc_px[other->first] - arc_px[center] <= kClusterPx; ++other) {
      views.push_back(other->second);
    }
    SortUnique(&views);
    const int count = static_cast<int>(views.size());
    if (count >= kMinSideViews) places.push_back({-count, center});
  }
  std::ranges::sort(places);
  std::vector<int> cuts;
  for (const auto& [count, center] : places) {
    const bool apart = std::ranges::all_of(cuts, [&, at = center](int other) {
      return std::abs(arc_px[other] - arc_px[at]) > 2 * kClusterPx;
    });
    if (apart) cuts.push_back(center);
  }
  std::ranges::sort(cuts, std::greater());
  return cuts;
}

}  // namespace

int64_t SplitAtSideEdges(const TopologyInput& input, const RunContext& context,
                         GraphEditor* editor) {
  const EdgelClaims claims = CollectClaims(input, editor->graph());
  std::vector<std::vector<LinkPoint>> of_view(input.views.size());
  ParallelFor(context, "side edges", of_view.size(), [&](size_t v) {
    of_view[v] = RunEnds(input, claims[v], static_cast<ViewId>(v)).Find();
  });
  const LinkId num_links = editor->NumLinks();
  std::vector<std::vector<std::pair<int, ViewId>>> seen(num_links);
  for (size_t v = 0; v < of_view.size(); ++v) {
    for (const auto& [link, index] : of_view[v]) {
      seen[link].push_back({index, static_cast<ViewId>(v)});
    }
  }
  int64_t num_nodes = 0;
  for (LinkId id = 0; id < num_links; ++id) {
    if (editor->link(id).closed) continue;
    std::ranges::sort(seen[id]);
    for (const int index : ChooseCuts(editor->link(id), seen[id])) {
      editor->Split(id, index);
      ++num_nodes;
    }
  }
  return num_nodes;
}

}  // namespace limn
