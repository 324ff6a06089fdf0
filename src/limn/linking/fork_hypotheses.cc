// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/fork_hypotheses.h"

#include <algorithm>
#include <tuple>

#include "limn/linking/continuation.h"

namespace limn {
namespace {

// How much better the other way must be, px of the score and as a factor.
constexpr double kMinGainPx = 2;
constexpr double kMinGainFactor = 1.3;

// An alternative continuation at a fork.
struct Alternative {
  DirectedLink link;
  double gain_px = 0;

  bool operator<(const Alternative& other) const {
    return std::tie(other.gain_px, link.from, link.to) <
           std::tie(gain_px, other.link.from, other.link.to);
  }
};

class ForkResolver {
 public:
  ForkResolver(const std::vector<Edgel>& edgels, const std::vector<SideColors>& colors,
               Chaining* chaining)
      : chaining_(*chaining), continuation_(edgels, colors, *chaining) {}

  void AddLink(const DirectedLink& link) { links_.push_back(link); }

  int Resolve() {
    std::sort(links_.begin(), links_.end());
    std::vector<Alternative> alternatives;
    for (const DirectedLink& link : links_) {
      const double gain_px = GainOf(link);
      if (gain_px > 0) alternatives.push_back({link, gain_px});
    }
    std::sort(alternatives.begin(), alternatives.end());
    int changes = 0;
    for (const Alternative& alternative : alternatives) {
      if (GainOf(alternative.link) <= 0) continue;  // the chains have changed
      Take(alternative.link);
      ++changes;
    }
    return changes;
  }

 private:
  // By how much a link is better than what is in its way, 0 if it is not or there is no fork.
  double GainOf(const DirectedLink& link) const {
    const EdgelId next = chaining_.next[link.from];
    const EdgelId prev = chaining_.prev[link.to];
    if (next == kInvalidEdgel && prev == kInvalidEdgel) return 0;
    if (continuation_.IsNearOnChain(link.from, link.to)) return 0;
    const double now = continuation_.Score(link.from, next) + continuation_.Score(prev, link.to);
    const double then = continuation_.Score(link.from, link.to) +
                        (AreLinked(prev, next) ? continuation_.Score(prev, next) : 0);
    return then > kMinGainFactor * now + kMinGainPx ? then - now : 0;
  }

  void Take(const DirectedLink& link) {
    const EdgelId next = chaining_.next[link.from];
    const EdgelId prev = chaining_.prev[link.to];
    chaining_.BreakAfter(link.from);
    if (prev != kInvalidEdgel) chaining_.BreakAfter(prev);
    chaining_.Join(link.from, link.to);
    if (AreLinked(prev, next)) chaining_.Join(prev, next);
  }

  bool AreLinked(EdgelId from, EdgelId to) const {
    return from != kInvalidEdgel && to != kInvalidEdgel &&
           std::binary_search(links_.begin(), links_.end(), DirectedLink{from, to});
  }

  Chaining& chaining_;
  Continuation continuation_;
  std::vector<DirectedLink> links_;  // sorted
};

}  // namespace

int ResolveForks(const std::vector<Edgel>& edgels, const std::vector<SideColors>& colors,
                 const std::vector<EdgelLink>& links, Chaining* chaining) {
  ForkResolver resolver(edgels, colors, chaining);
  const std::vector<Eigen::Vector2d> tangents = TangentsOf(edgels);
  for (const EdgelLink& link : links) {
    if (const auto directed = Direct(edgels, tangents, link)) resolver.AddLink(*directed);
  }
  return resolver.Resolve();
}

}  // namespace limn
