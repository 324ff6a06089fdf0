// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/linking.h"

#include <algorithm>
#include <utility>

#include "limn/linking/fork_hypotheses.h"
#include "limn/linking/fragment_cleanup.h"
#include "limn/linking/fragment_geometry.h"
#include "limn/linking/link_graph.h"
#include "limn/linking/side_colors.h"
#include "limn/linking/tangent_fit.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Move the long enough chains to the result and count the rest.
void KeepLongChains(std::vector<CurveFragment> chains, double min_length_px,
                    LinkingResult* result) {
  LinkingStats& stats = result->stats;
  int64_t in_chains = 0;
  for (CurveFragment& chain : chains) {
    const auto size = static_cast<int64_t>(chain.edgel_ids.size());
    in_chains += size;
    const double length = FragmentPath(result->curves.edge_map.edgels, chain).Length();
    if (length < min_length_px) {
      stats.edgels_in_short_chains += size;
      ++stats.short_chains;
      continue;
    }
    stats.edgels_in_fragments += size;
    stats.fragments_length_px += length;
    result->curves.fragments.push_back(std::move(chain));
  }
  stats.fragments = static_cast<int64_t>(result->curves.fragments.size());
  stats.edgels_unlinked = stats.edgels - stats.edgels_in_texture - in_chains;
}

std::vector<EdgelLink> LinkOutsideTexture(const EdgeMap& map, const LinkingOptions& options,
                                          int64_t* num_curvelets) {
  if (map.texture.empty()) return BuildLinkGraph(map.edgels, options, num_curvelets);
  std::vector<EdgelId> ids;
  std::vector<Edgel> edgels;
  auto next = map.texture.begin();
  for (EdgelId id = 0; id < static_cast<EdgelId>(map.edgels.size()); ++id) {
    if (next != map.texture.end() && *next == id) {
      ++next;
      continue;
    }
    ids.push_back(id);
    edgels.push_back(map.edgels[id]);
  }
  std::vector<EdgelLink> links = BuildLinkGraph(edgels, options, num_curvelets);
  for (EdgelLink& link : links) link = {ids[link.a], ids[link.b], link.votes};
  return links;
}

Chaining ChainEdgels(const LinkingOptions& options, const Image* image, LinkingResult* result) {
  const std::vector<Edgel>& edgels = result->curves.edge_map.edgels;
  Chaining chaining = ChainMutualBest(edgels, result->link_graph);
  if (options.forks == ForkChoice::kHypotheses) {
    result->stats.changed_forks =
        ResolveForks(edgels, MeasureSideColors(edgels, image), result->link_graph, &chaining);
  }
  return chaining;
}

// Edgels outside texture that are in no link and in no fragment.
int CountUnlinked(const LinkingResult& result) {
  const EdgeMap& map = result.curves.edge_map;
  std::vector<bool> linked(map.edgels.size(), false);
  for (const EdgelLink& link : result.link_graph) linked[link.a] = linked[link.b] = true;
  for (const CurveFragment& fragment : result.curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) linked[id] = true;
  }
  return static_cast<int>(std::ranges::count(linked, false) - std::ssize(map.texture));
}

}  // namespace

LinkingResult LinkEdgels(EdgeMap edge_map, const LinkingOptions& options, const Image* image) {
  options.Check();
  LinkingResult result;
  result.curves.edge_map = std::move(edge_map);
  std::vector<Edgel>& edgels = result.curves.edge_map.edgels;
  LinkingStats& stats = result.stats;
  stats.edgels = static_cast<int64_t>(edgels.size());
  stats.edgels_in_texture = static_cast<int64_t>(result.curves.edge_map.texture.size());

  result.link_graph = LinkOutsideTexture(result.curves.edge_map, options, &stats.curvelets);
  stats.graph_links = static_cast<int64_t>(result.link_graph.size());
  Chaining chaining = ChainEdgels(options, image, &result);
  SmoothChains smooth;
  stats.corner_breaks = BreakAtCorners(edgels, &smooth, &chaining);
  stats.bridged_gaps = BridgeGaps(edgels, options, &chaining);
  stats.corner_breaks += BreakAtCorners(edgels, &smooth, &chaining);
  stats.junction_breaks = BreakAtJunctions(edgels, options, &chaining);

  KeepLongChains(TraceChains(chaining), options.min_length_px, &result);
  for (const CurveFragment& fragment : result.curves.fragments) {
    RefitTangents(fragment, kTangentArmPx, &edgels);
  }
  result.curves.num_unlinked = CountUnlinked(result);
  return result;
}

}  // namespace limn
