#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "limn/geometry/spatial_index.h"
#include "limn/refinement/topology_edits.h"

namespace limn {
namespace {

// A node this much farther away than a place on a link is still preferred, px; nearer to a node
// than this a link is not cut.
constexpr int kNodePreferencePx = 3;

class EndSnapper {
 public:
  explicit EndSnapper(GraphEditor* editor)
      : editor_(editor), places_(editor->CollectPlaces()), index_(places_.position) {}

  SnapCounts Run() {
    Choose();
    SnapCounts counts;
    counts.to_nodes = static_cast<int64_t>(moves_.size());
    CutLinks();
    counts.to_links = static_cast<int64_t>(moves_.size()) - counts.to_nodes;
    RebuildIncidence(&editor_->graph());
    for (const auto& [from, to] : moves_) Move(from, to);
    editor_->Keep(std::vector<uint8_t>(editor_->graph().links.size(), 1));
    return counts;
  }

 private:
  struct Target {
    double cost_px = std::numeric_limits<double>::infinity();
    NodeId node = -1;  // else inside a link
    LinkId link = -1;
    int index = -1;
  };

  // Which free node goes where. Nodes are the same whatever happens to their links.
  void Choose() {
    std::vector<uint8_t> leaves(editor_->graph().nodes.size(), 0);
    std::vector<uint8_t> stays(editor_->graph().nodes.size(), 0);
    std::vector<uint8_t> opened(editor_->graph().links.size(), 0);
    for (const LinkEnd& free : editor_->FreeEnds()) {
      const NodeId from = NodeAt(editor_->link(free.link), free.end);
      if (stays[from]) continue;
      const Target target = FindTarget(free);
      if (target.node >= 0) {
        if (leaves[target.node]) continue;
        stays[target.node] = 1;
        moves_.push_back({from, target.node});
      } else if (target.link >= 0) {
        // The indices of a loop change when it is cut: once is enough.
        if (std::exchange(opened[target.link], editor_->link(target.link).closed)) continue;
        cuts_[{target.link, target.index}].push_back(from);
      } else {
        continue;
      }
      leaves[from] = 1;
    }
  }

  Target FindTarget(const LinkEnd& free) {
    Target best;
    const LinkTip tip = editor_->Tip(free);
    const double footprint = editor_->FootprintOf(free.link);
    index_.FindWithin(tip.point, (kMaxGapPx + kMaxMissPx) * footprint, &near_);
    for (const SpatialIndex::Neighbor& neighbor : near_) {
      const auto& [other, at] = places_.point[neighbor.index];
      if (other == free.link) continue;
      const auto reach = editor_->Reaches(tip, places_.position[neighbor.index], footprint);
      if (!reach) continue;
      const DrawingLink& link = editor_->link(other);
      const int last = static_cast<int>(link.points_in_world.size()) - 1;
      const bool is_node = !link.closed && (at == 0 || at == last);
      const bool near_node = !link.closed && std::min(at, last - at) < kNodePreferencePx;
      if (near_node && !is_node) continue;
      const double cost_px =
          std::abs(reach->along_px) + 2 * reach->miss_px - (is_node ? kNodePreferencePx : 0);
      if (cost_px >= best.cost_px) continue;
      const NodeId node = is_node ? NodeAt(link, at == 0 ? 0 : 1) : -1;
      const bool parts =
          is_node
              ? PartsFromAll(free, tip, node)
              : LineAngleBetween(tip.outward, places_.direction[neighbor.index]) > kMinPartingRad;
      if (!parts) continue;
      if (std::abs(reach->along_px) > kSmallGapPx &&
          !editor_->ImagesShow(tip.point, places_.position[neighbor.index], free.link, other)) {
        continue;
      }
      best = is_node ? Target{cost_px, node, -1, -1} : Target{cost_px, -1, other, at};
    }
    return best;
  }

  // At the node the link would not run along another one, and it is not its own.
  bool PartsFromAll(const LinkEnd& free, const LinkTip& tip, NodeId id) const {
    const auto& incident = editor_->graph().nodes[id].incident;
    return std::all_of(incident.begin(), incident.end(), [&](const LinkEnd& end) {
      return end.link != free.link &&
             AngleBetween(editor_->Tip(end).outward, tip.outward) > kMinPartingRad;
    });
  }

  // From the back of each link, so that indices before the cut stay. Places near each other get one
  // node.
  void CutLinks() {
    std::pair<LinkId, int> last = {-1, 0};
    NodeId node = -1;
    for (auto it = cuts_.rbegin(); it != cuts_.rend(); ++it) {
      const auto& [link, index] = it->first;
      if (link != last.first || last.second - index >= kNodePreferencePx) {
        node = editor_->Split(link, index, /*smooth=*/true);
        last = it->first;
      }
      for (const NodeId from : it->second) moves_.push_back({from, node});
    }
  }

  void Move(NodeId from, NodeId to) {
    const LinkEnd end = editor_->graph().nodes[from].incident.front();
    AddContinuation(to, end);
    EndLinkAt(end, to, &editor_->graph());
  }

  // An end that comes to a node goes on in the link there that nothing else goes on in.
  void AddContinuation(NodeId id, const LinkEnd& end) {
    DrawingNode& node = editor_->graph().nodes[id];
    double least = kMaxTurnRad;
    LinkEnd best;
    for (const LinkEnd& other : node.incident) {
      const bool goes_on = std::any_of(
          node.continuations.begin(), node.continuations.end(),
          [&](const auto& pair) { return pair.first == other || pair.second == other; });
      const double turn = AngleBetween(editor_->Tip(other).outward, -editor_->Tip(end).outward);
      if (goes_on || turn >= least) continue;
      least = turn;
      best = other;
    }
    if (best.link >= 0) node.continuations.push_back(std::minmax(best, end));
  }

  GraphEditor* editor_;
  GraphEditor::Places places_;
  SpatialIndex index_;
  std::vector<SpatialIndex::Neighbor> near_;
  std::vector<std::pair<NodeId, NodeId>> moves_;  // free node, where it goes
  std::map<std::pair<LinkId, int>, std::vector<NodeId>> cuts_;
};

}  // namespace

SnapCounts SnapEnds(GraphEditor* editor) { return EndSnapper(editor).Run(); }

}  // namespace limn
