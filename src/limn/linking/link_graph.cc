// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/link_graph.h"

#include <algorithm>
#include <utility>

#include "limn/linking/curvelets.h"

namespace limn {
namespace {

struct BestLink {
  EdgelId to = kInvalidEdgel;
  int votes = 0;
  double distance = 0;

  bool IsWorseThan(const BestLink& other) const {
    if (votes != other.votes) return votes < other.votes;
    if (distance != other.distance) return distance > other.distance;
    return to > other.to;
  }
};

void Offer(const BestLink& candidate, BestLink* best) {
  if (best->to == kInvalidEdgel || best->IsWorseThan(candidate)) *best = candidate;
}

// For a link from the smaller to the larger id.
using Vote = std::pair<EdgelId, EdgelId>;

// The links that were voted for, sorted. Linear time, as few votes share their first edgel.
std::vector<EdgelLink> CountVotes(const std::vector<Vote>& votes, size_t num_edgels) {
  std::vector<size_t> end_of(num_edgels + 1, 0);
  for (const auto& [a, b] : votes) ++end_of[a + 1];
  for (size_t a = 1; a <= num_edgels; ++a) end_of[a] += end_of[a - 1];
  // Now end_of[a] is where those of a begin; filling in moves it to their end.
  std::vector<EdgelId> targets(votes.size());
  for (const auto& [a, b] : votes) targets[end_of[a]++] = b;
  std::vector<EdgelLink> links;
  auto begin = targets.begin();
  for (size_t a = 0; a < num_edgels; ++a) {
    const auto end = targets.begin() + static_cast<std::ptrdiff_t>(end_of[a]);
    std::sort(begin, end);
    while (begin != end) {
      const auto next = std::find_if(begin, end, [&](EdgelId b) { return b != *begin; });
      links.push_back({static_cast<EdgelId>(a), *begin, static_cast<int>(next - begin)});
      begin = next;
    }
  }
  return links;
}

CurveFragment Trace(const Chaining& chaining, EdgelId start, std::vector<uint8_t>* seen) {
  CurveFragment chain;
  size_t size = 0;
  for (EdgelId e = start; e != kInvalidEdgel && !(*seen)[e]; e = chaining.next[e]) {
    (*seen)[e] = 1;
    ++size;
  }
  chain.edgel_ids.reserve(size);
  for (EdgelId e = start; chain.edgel_ids.size() < size; e = chaining.next[e]) {
    chain.edgel_ids.push_back(e);
  }
  chain.closed = chaining.prev[start] != kInvalidEdgel;
  return chain;
}

}  // namespace

void Chaining::Join(EdgelId from, EdgelId to) {
  next[from] = to;
  prev[to] = from;
}

void Chaining::BreakAfter(EdgelId from) {
  if (next[from] == kInvalidEdgel) return;
  prev[next[from]] = kInvalidEdgel;
  next[from] = kInvalidEdgel;
}

std::vector<Eigen::Vector2d> TangentsOf(const std::vector<Edgel>& edgels) {
  std::vector<Eigen::Vector2d> tangents;
  tangents.reserve(edgels.size());
  for (const Edgel& edgel : edgels) tangents.push_back(edgel.Tangent());
  return tangents;
}

std::optional<DirectedLink> Direct(const std::vector<Edgel>& edgels,
                                   const std::vector<Eigen::Vector2d>& tangents,
                                   const EdgelLink& link) {
  const Eigen::Vector2d d = edgels[link.b].position_px - edgels[link.a].position_px;
  const double along_a = d.dot(tangents[link.a]);
  if (along_a * d.dot(tangents[link.b]) <= 0) return std::nullopt;
  return along_a > 0 ? DirectedLink{link.a, link.b} : DirectedLink{link.b, link.a};
}

std::vector<EdgelLink> BuildLinkGraph(const std::vector<Edgel>& edgels,
                                      const LinkingOptions& options, int64_t* num_curvelets) {
  CurveletBuilder builder(edgels, options);
  std::vector<Vote> votes;
  int64_t count = 0;
  for (size_t i = 0; i < edgels.size(); ++i) {
    for (const Curvelet& curvelet : builder.Around(static_cast<EdgelId>(i))) {
      ++count;
      for (size_t k = 1; k < curvelet.size(); ++k) {
        votes.push_back(std::minmax(curvelet[k - 1], curvelet[k]));
      }
    }
  }
  if (num_curvelets) *num_curvelets = count;
  return CountVotes(votes, edgels.size());
}

Chaining ChainMutualBest(const std::vector<Edgel>& edgels, const std::vector<EdgelLink>& links) {
  std::vector<BestLink> ahead(edgels.size());
  std::vector<BestLink> behind(edgels.size());
  const std::vector<Eigen::Vector2d> tangents = TangentsOf(edgels);
  for (const EdgelLink& link : links) {
    const auto directed = Direct(edgels, tangents, link);
    if (!directed) continue;
    const auto [from, to] = *directed;
    const double distance = (edgels[to].position_px - edgels[from].position_px).norm();
    Offer({to, link.votes, distance}, &ahead[from]);
    Offer({from, link.votes, distance}, &behind[to]);
  }
  Chaining chaining(edgels.size());
  for (size_t i = 0; i < edgels.size(); ++i) {
    const EdgelId to = ahead[i].to;
    if (to != kInvalidEdgel && behind[to].to == static_cast<EdgelId>(i)) {
      chaining.Join(static_cast<EdgelId>(i), to);
    }
  }
  return chaining;
}

std::vector<CurveFragment> TraceChains(const Chaining& chaining) {
  const EdgelId count = static_cast<EdgelId>(chaining.next.size());
  std::vector<uint8_t> seen(count, 0);
  std::vector<CurveFragment> chains;
  for (EdgelId e = 0; e < count; ++e) {
    if (chaining.prev[e] != kInvalidEdgel || chaining.next[e] == kInvalidEdgel) continue;
    chains.push_back(Trace(chaining, e, &seen));
  }
  // What is left and has a successor is on a cycle.
  for (EdgelId e = 0; e < count; ++e) {
    if (seen[e] || chaining.next[e] == kInvalidEdgel) continue;
    chains.push_back(Trace(chaining, e, &seen));
  }
  std::sort(chains.begin(), chains.end(), [](const CurveFragment& a, const CurveFragment& b) {
    return a.edgel_ids[0] < b.edgel_ids[0];
  });
  return chains;
}

}  // namespace limn
