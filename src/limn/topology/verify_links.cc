// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/verify_links.h"

#include <algorithm>
#include <optional>
#include <set>

#include "limn/geometry/tangent_frame.h"
#include "limn/model/view_finder.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Primary views that the samples of a link must come from.
constexpr int kMinMergedViews = 2;
// An edgel within this distance of a claimed one belongs to the same edge, virtual px.
constexpr double kSameEdgePx = 1.5;
// Shifts of the copies that measure chance, px, each in two directions across the link.
constexpr double kShiftsPx[] = {-10, -6, 6, 10};

// Number of agreeing primary views, averaged along a link. Points that were added do not count.
double MeanAgreement(const DrawingLink& link) {
  double sum = 0;
  double length_px = 0;
  for (int k = 0; k < link.size(); ++k) {
    const int here = link.vertices[k].agreeing_views;
    if (here == 0) continue;
    const double own_px = ArcPx(link, std::max(k - 1, 0), std::min(k + 1, link.size() - 1));
    sum += here * own_px;
    length_px += own_px;
  }
  return length_px > 0 ? sum / length_px : 0;
}

// Mean number of views that contain a point of a link.
double MeanContaining(const DrawingLink& link, const std::vector<ViewId>& near,
                      const std::vector<View>& views) {
  int64_t sum = 0;
  for (const Eigen::Vector3d& point : link.points_in_world) {
    sum += std::count_if(near.begin(), near.end(),
                         [&](ViewId v) { return views[v].Project(point).has_value(); });
  }
  return static_cast<double>(sum) / link.size();
}

// Number of primary views that the samples of a link come from.
int NumPrimaryViews(const CurveSketch& sketch, const DrawingLink& link) {
  std::set<ViewId> views;
  for (const LinkVertex& vertex : link.vertices) {
    for (const SketchSample& from : vertex.samples) {
      views.insert(sketch.curves[from.curve].anchor.view);
    }
  }
  return static_cast<int>(views.size());
}

enum class Belief : uint8_t { kNo, kUncertain, kCertain };

struct FirstJudgment {
  Belief belief = Belief::kNo;
  double num_containing = 0;  // mean number of views that contain a point of the link
  std::vector<ViewId> near;   // views that may contain the link
};

FirstJudgment Judge(const TopologyInput& input, const CurveSketch& sketch,
                    const TopologyOptions& options, const DrawingLink& link,
                    std::vector<ViewId> near) {
  const double num_containing = MeanContaining(link, near, input.views);
  const double required = std::clamp(options.primary_views_share * num_containing,
                                     options.min_primary_views, options.max_primary_views);
  Belief belief = MeanAgreement(link) >= required ? Belief::kCertain : Belief::kUncertain;
  if (NumPrimaryViews(sketch, link) < kMinMergedViews) belief = Belief::kNo;
  return {belief, num_containing, std::move(near)};
}

// The edgels of a view that certain links explain.
EdgelIndex ClaimedEdgels(const TopologyInput& input, const DrawingGraph& graph,
                         const std::vector<FirstJudgment>& first, ViewId view) {
  const EdgeMap& edge_map = input.curves[view].edge_map;
  std::vector<bool> claimed(edge_map.edgels.size());
  for (size_t l = 0; l < first.size(); ++l) {
    if (first[l].belief != Belief::kCertain) continue;
    if (!std::ranges::binary_search(first[l].near, view)) continue;
    const DrawingLink& link = graph.links[l];
    for (int k = 0; k < link.size(); ++k) {
      const auto edgel =
          input.EdgelAt(view, link.points_in_world[k], TangentAt(link, k), input.gate);
      if (edgel) claimed[edgel->edgel] = true;
    }
  }
  return {edge_map, claimed};
}

// Copies of a point of a link, shifted across it.
std::vector<Eigen::Vector3d> ShiftedCopies(const DrawingLink& link, int index) {
  const Eigen::Matrix<double, 3, 2> across =
      link.vertices[index].footprint * TangentFrame(TangentAt(link, index));
  std::vector<Eigen::Vector3d> copies;
  for (const double shift : kShiftsPx) {
    for (const Eigen::Vector3d offset : across.colwise()) {
      copies.push_back(link.points_in_world[index] + shift * offset);
    }
  }
  return copies;
}

// Mean number of views in which unclaimed edgels run along a link, less the number expected by
// chance. Copies count claimed edgels, too, so that links beside known edges need more support.
double OwnViews(const TopologyInput& input, const std::vector<std::optional<EdgelIndex>>& claimed,
                const DrawingLink& link, const std::vector<ViewId>& near) {
  const std::vector<int> probes = ProbePoints(link);
  int64_t own = 0;
  int64_t contained = 0;
  int64_t num_copies = 0;
  int64_t num_with_edgel = 0;
  for (const int k : probes) {
    const Eigen::Vector3d& point = link.points_in_world[k];
    const Eigen::Vector3d tangent = TangentAt(link, k);
    const std::vector<Eigen::Vector3d> copies = ShiftedCopies(link, k);
    for (const ViewId v : near) {
      if (!input.views[v].Project(point)) continue;
      ++contained;
      const auto edgel = input.EdgelAt(v, point, tangent, input.gate);
      own += edgel && !claimed[v]->AnyWithin(input.EdgelOf(*edgel).position_px, kSameEdgePx);
      for (const Eigen::Vector3d& copy : copies) {
        if (!input.views[v].Project(copy)) continue;
        ++num_copies;
        num_with_edgel += input.EdgelAt(v, copy, tangent, input.gate).has_value();
      }
    }
  }
  if (num_copies == 0) return 0;
  const double chance = static_cast<double>(num_with_edgel) / num_copies;
  return (own - chance * contained) / static_cast<double>(probes.size());
}

}  // namespace

std::vector<uint8_t> VerifyLinks(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const DrawingGraph& graph,
                                 const RunContext& context) {
  const ViewFinder finder(input.views);
  const auto first = MapItems(context, "link agreement", graph.links.size(), [&](size_t l) {
    const DrawingLink& link = graph.links[l];
    return Judge(input, sketch, options, link, finder.NearAnyOf(link.points_in_world));
  });
  std::vector<std::optional<EdgelIndex>> claimed(input.views.size());
  ParallelFor(context, "claimed edgels", claimed.size(), [&](size_t v) {
    claimed[v] = ClaimedEdgels(input, graph, first, static_cast<ViewId>(v));
  });
  return MapItems(context, "link support", first.size(), [&](size_t l) -> uint8_t {
    const auto& [belief, num_containing, near] = first[l];
    if (belief != Belief::kUncertain) return belief == Belief::kCertain;
    const double required = std::clamp(options.own_views_share * num_containing,
                                       options.min_own_views, options.max_own_views);
    return OwnViews(input, claimed, graph.links[l], near) >= required;
  });
}

}  // namespace limn
