// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/texture.h"

#include <algorithm>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Limits were chosen: algorithm/kinds.md#texture.
// What is looked at around the middle of a link, px. Texture fills areas; small parts, such as
// backs of books, have long edges not far away.
constexpr double kTextureReachPx = 120;
constexpr double kMinShortShare = 0.8;
// A sign by itself has fewer.
constexpr size_t kMinFreeEnds = 32;
// Between the places that stand for a link's length, px.
constexpr double kTextureStepPx = 4;

bool IsBelieved(const DrawingLink& link) { return !link.tentative && link.IsAlongEdgels(); }

std::vector<Eigen::Vector3d> FreeEnds(const DrawingGraph& graph) {
  std::vector<int> degree(graph.nodes.size(), 0);
  for (const DrawingLink& link : graph.links) {
    if (!IsBelieved(link)) continue;
    ++degree[link.node0];
    ++degree[link.node1];
  }
  std::vector<Eigen::Vector3d> ends;
  for (size_t n = 0; n < degree.size(); ++n) {
    if (degree[n] == 1) ends.push_back(graph.nodes[n].position_in_world);
  }
  return ends;
}

// Places along believed links, each for the same length in px.
struct Places {
  std::vector<Eigen::Vector3d> positions;
  std::vector<uint8_t> is_short;
};

Places PlacesOf(const std::vector<View>& views, const DrawingGraph& graph) {
  Places places;
  for (const DrawingLink& link : graph.links) {
    const double footprint = LinkFootprint(link, views);
    if (!IsBelieved(link) || !(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, kTextureStepPx * footprint);
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      places.positions.push_back(0.5 * (points[k] + points[k + 1]));
      places.is_short.push_back(link.IsOfShortCurve());
    }
  }
  return places;
}

class Surroundings {
 public:
  Surroundings(const std::vector<View>& views, const DrawingGraph& graph)
      : places_(PlacesOf(views, graph)), by_place_(places_.positions), by_end_(FreeEnds(graph)) {}

  // Of the believed length within a distance, the share of short curves.
  double ShortShare(const Eigen::Vector3d& around, double reach) const {
    std::vector<SpatialIndex::Neighbor> near;
    by_place_.FindWithin(around, reach, &near);
    const auto num_short = std::ranges::count_if(
        near, [&](const SpatialIndex::Neighbor& place) { return places_.is_short[place.index]; });
    return near.empty() ? 0 : static_cast<double>(num_short) / static_cast<double>(near.size());
  }

  size_t NumFreeEnds(const Eigen::Vector3d& around, double reach) const {
    std::vector<SpatialIndex::Neighbor> near;
    by_end_.FindWithin(around, reach, &near);
    return near.size();
  }

 private:
  Places places_;
  SpatialIndex by_place_, by_end_;
};

StageSummary SummarizeTexture(const DrawingGraph& graph) {
  const auto num_links = static_cast<int64_t>(graph.links.size());
  const int64_t num_texture =
      std::ranges::count(graph.links, LinkKind::kTexture, &DrawingLink::kind);
  StageSummary summary;
  summary.stage = "texture";
  summary.in = {{"links", num_links}};
  summary.kept = {{"links: texture", num_texture}, {"links: others", num_links - num_texture}};
  return summary;
}

}  // namespace

void MeasureCurves(const std::vector<View>& views, DrawingGraph* graph) {
  auto& links = graph->links;
  UnionFind curves(static_cast<int>(links.size()));
  for (const DrawingNode& node : graph->nodes) {
    for (const auto& [a, b] : node.continuations) {
      if (IsBelieved(links[a.link]) && IsBelieved(links[b.link])) curves.Union(a.link, b.link);
    }
  }
  std::vector<double> length_px(links.size(), 0);
  for (LinkId id = 0; id < static_cast<LinkId>(links.size()); ++id) {
    const double footprint = LinkFootprint(links[id], views);
    if (!(footprint > 0)) continue;
    length_px[curves.Find(id)] += Length(links[id].points_in_world) / footprint;
  }
  for (LinkId id = 0; id < static_cast<LinkId>(links.size()); ++id) {
    links[id].curve_px = length_px[curves.Find(id)];
  }
}

StageSummary MarkTexture(const std::vector<View>& views, DrawingGraph* graph) {
  const Surroundings surroundings(views, *graph);
  for (DrawingLink& link : graph->links) {
    if (!IsBelieved(link) || !link.IsOfShortCurve() || link.node0 == link.node1) continue;
    const Eigen::Vector3d& middle = link.points_in_world[link.points_in_world.size() / 2];
    const double reach = kTextureReachPx * LinkFootprint(link, views);
    const double short_share = surroundings.ShortShare(middle, reach);
    if (short_share < kMinShortShare || surroundings.NumFreeEnds(middle, reach) < kMinFreeEnds) {
      continue;
    }
    link.kind = LinkKind::kTexture;
    link.kind_confidence = short_share;
  }
  return SummarizeTexture(*graph);
}

}  // namespace limn
