// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/tidy.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "limn/topology/covered_links.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Shortest link between two nodes, px.
constexpr double kMinBridgePx = 2;
// Turns are alike if their cosines differ by less than this.
constexpr double kAlike = 0.02;

struct Leaving {
  LinkEnd end;
  Eigen::Vector3d direction;  // unit, into the link
  double length_px = 0;
};

// The two links that leave a node at the smallest angle; -1, -1 if no angle is small enough.
std::pair<int, int> SharpestPair(const std::vector<Leaving>& leaving, double min_cosine) {
  std::pair<int, int> best = {-1, -1};
  double largest = min_cosine;
  for (int i = 0; i < static_cast<int>(leaving.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(leaving.size()); ++j) {
      const double cosine = leaving[i].direction.dot(leaving[j].direction);
      if (cosine <= largest) continue;
      largest = cosine;
      best = {i, j};
    }
  }
  return best;
}

// Cosine of the smallest turn from a third link of the node into link `i` of a pair; -1 if there is
// no third link.
double SmallestTurn(const std::vector<Leaving>& leaving, int i, int partner) {
  double cosine = -1;
  for (int k = 0; k < static_cast<int>(leaving.size()); ++k) {
    if (k == i || k == partner) continue;
    cosine = std::max(cosine, -leaving[i].direction.dot(leaving[k].direction));
  }
  return cosine;
}

Eigen::Vector3d Outward(const GraphEditor& editor, const LinkEnd& end) {
  return TipOf(editor.link(end.link), end.end).outward;
}

bool IsShort(const TopologyOptions& options, const GraphEditor& editor, LinkId id) {
  const DrawingLink& link = editor.link(id);
  const bool tied[2] = {editor.node(link.node0).Degree() > 1, editor.node(link.node1).Degree() > 1};
  const bool is_bridge = tied[0] && tied[1] && link.node0 != link.node1;
  const bool has_grown = NumSketchSamples(link) == 0 && (tied[0] || tied[1]) && !link.closed;
  return LengthPx(link) < (is_bridge || has_grown ? kMinBridgePx : options.min_link_length_px);
}

}  // namespace

int64_t KeepAndCount(const std::vector<uint8_t>& keep, GraphEditor* editor) {
  int64_t num_samples = 0;
  for (size_t l = 0; l < keep.size(); ++l) {
    if (!keep[l]) num_samples += NumSketchSamples(editor->link(static_cast<LinkId>(l)));
  }
  editor->Keep(keep);
  return num_samples;
}

int64_t CutForks(const TopologyOptions& options, GraphEditor* editor) {
  const double fork = std::cos(options.min_junction_angle_deg * kDeg);
  int64_t num_freed = 0;
  const auto num_nodes = static_cast<NodeId>(editor->graph().nodes.size());
  for (NodeId node = 0; node < num_nodes; ++node) {
    std::vector<Leaving> leaving;
    for (const LinkEnd& end : editor->node(node).incident) {
      leaving.push_back({end, -Outward(*editor, end), LengthPx(editor->link(end.link))});
    }
    while (leaving.size() > 2) {
      const auto [i, j] = SharpestPair(leaving, fork);
      if (i < 0) break;
      const double turn_i = SmallestTurn(leaving, i, j);
      const double turn_j = SmallestTurn(leaving, j, i);
      const bool keep_i = std::abs(turn_i - turn_j) > kAlike
                              ? turn_i > turn_j
                              : leaving[i].length_px >= leaving[j].length_px;
      const int freed = keep_i ? j : i;
      editor->Free(leaving[freed].end);
      leaving.erase(leaving.begin() + freed);
      ++num_freed;
    }
  }
  return num_freed;
}

int64_t DissolveNodes(const TopologyOptions& options, GraphEditor* editor) {
  const double max_turn_rad = options.max_continuation_angle_deg * kDeg;
  int64_t num_dissolved = 0;
  std::set<NodeId> waiting;
  for (NodeId id = 0; id < static_cast<NodeId>(editor->graph().nodes.size()); ++id) {
    waiting.insert(id);
  }
  while (!waiting.empty()) {
    const NodeId id = *waiting.begin();
    waiting.erase(waiting.begin());
    const DrawingNode& node = editor->node(id);
    if (node.Degree() != 2 || node.kind == NodeKind::kLoopAnchor) continue;
    const LinkEnd a = node.incident[0];
    const LinkEnd b = node.incident[1];
    const LinkTip tips[2] = {TipOf(editor->link(a.link), a.end),
                             TipOf(editor->link(b.link), b.end)};
    if (TurnBetween(tips[0], tips[1]) >= max_turn_rad) continue;
    editor->Join(a, b);
    ++num_dissolved;
    // The longer link may now continue others at its ends.
    waiting.insert(editor->link(a.link).node0);
    waiting.insert(editor->link(a.link).node1);
  }
  editor->Compact();
  return num_dissolved;
}

int64_t RemoveShortLinks(const TopologyOptions& options, GraphEditor* editor) {
  std::vector<uint8_t> keep;
  for (LinkId id = 0; id < editor->NumLinks(); ++id) keep.push_back(!IsShort(options, *editor, id));
  return KeepAndCount(keep, editor);
}

TidyCounts Tidy(const TopologyOptions& options, GraphEditor* editor) {
  TidyCounts counts;
  counts.forks_cut = CutForks(options, editor);
  counts.dissolved_nodes += DissolveNodes(options, editor);
  counts.samples_covered += KeepAndCount(FindUncoveredLinks(options, editor->graph()), editor);
  for (bool changed = true; changed;) {
    counts.dissolved_nodes += DissolveNodes(options, editor);
    const int before = editor->NumLinks();
    counts.samples_short += RemoveShortLinks(options, editor);
    changed = editor->NumLinks() < before;
  }
  return counts;
}

}  // namespace limn
