// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "limn/linking/linking_options.h"
#include "limn/model/curve_fragment.h"

namespace limn {

// Every edgel's successor and predecessor along its curve; kInvalidEdgel at the ends. Invariant:
// next[a] == b exactly if prev[b] == a.
struct Chaining {
  std::vector<EdgelId> next;
  std::vector<EdgelId> prev;

  explicit Chaining(size_t count) : next(count, kInvalidEdgel), prev(count, kInvalidEdgel) {}
  // `from` must have no successor and `to` no predecessor.
  void Join(EdgelId from, EdgelId to);
  // Removes the link from `from` to its successor.
  void BreakAfter(EdgelId from);
};

// A link that continues along the tangents of both edgels.
struct DirectedLink {
  EdgelId from = kInvalidEdgel;
  EdgelId to = kInvalidEdgel;
  auto operator<=>(const DirectedLink&) const = default;
};

// An undirected link: the two edgels are neighbors in `votes` curvelets.
struct EdgelLink {
  EdgelId a = kInvalidEdgel;  // a < b
  EdgelId b = kInvalidEdgel;
  int votes = 0;
};

std::vector<Eigen::Vector2d> TangentsOf(const std::vector<Edgel>& edgels);

// Nothing for a link that runs sideways from one of its edgels: a hint of a junction, but not a
// continuation.
std::optional<DirectedLink> Direct(const std::vector<Edgel>& edgels,
                                   const std::vector<Eigen::Vector2d>& tangents,
                                   const EdgelLink& link);

// All links that curvelets vote for, sorted by (a, b). `num_curvelets` may be null.
std::vector<EdgelLink> BuildLinkGraph(const std::vector<Edgel>& edgels,
                                      const LinkingOptions& options, int64_t* num_curvelets);

// Keeps the links that are the best ahead of one edgel and the best behind the other: most votes,
// then shortest. Linear time.
Chaining ChainMutualBest(const std::vector<Edgel>& edgels, const std::vector<EdgelLink>& links);

// The chains of two edgels or more, ordered by their first edgel. A closed chain begins at its
// smallest id and does not repeat it.
std::vector<CurveFragment> TraceChains(const Chaining& chaining);

}  // namespace limn
