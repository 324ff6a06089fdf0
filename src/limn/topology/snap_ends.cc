// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/snap_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/spatial_index.h"
#include "limn/topology/join_ends.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A node is preferred to interior places up to this much nearer, px. Links are not split within
// this distance of their ends, and cuts within it share a node.
constexpr double kNodePreferencePx = 3;

class EndSnapper {
 public:
  explicit EndSnapper(const MeetingTask& task)
      : task_(task),
        editor_(task.editor),
        min_parting_rad_(task.options.min_junction_angle_deg * kDeg),
        places_(CollectPlaces(task.editor->graph())),
        index_(places_.position) {}

  void Run() {
    Choose();
    CutLinks();
    for (const auto& [from, to] : moves_) {
      editor_->EndAt(editor_->node(from).incident.front(), to);
    }
    editor_->Compact();
  }

 private:
  struct Target {
    double cost_px = std::numeric_limits<double>::infinity();
    NodeId node = -1;  // else inside a link
    LinkId link = -1;
    int index = -1;
  };

  // Chooses which free node moves where. Nodes keep their ids while links are edited.
  void Choose() {
    std::vector<uint8_t> leaves(editor_->graph().nodes.size(), 0);
    std::vector<uint8_t> stays(editor_->graph().nodes.size(), 0);
    std::vector<uint8_t> opened(editor_->NumLinks(), 0);
    for (const LinkEnd& free : editor_->FreeEnds()) {
      const NodeId from = editor_->NodeAt(free);
      if (stays[from] || editor_->link(free.link).vertices.empty()) continue;
      const Target target = FindTarget(free);
      if (target.node >= 0) {
        if (leaves[target.node]) continue;
        stays[target.node] = 1;
        moves_.push_back({from, target.node});
        ++task_.counts->to_nodes;
      } else if (target.link >= 0) {
        // Splitting a loop changes its indices, so it is split at most once.
        if (std::exchange(opened[target.link], editor_->link(target.link).closed)) continue;
        cuts_.push_back({target.link, target.index, from});
        ++task_.counts->to_links;
      } else {
        continue;
      }
      leaves[from] = 1;
    }
  }

  Target FindTarget(const LinkEnd& free) {
    Target best;
    Eigen::Vector3d best_place = Eigen::Vector3d::Zero();
    const LinkTip tip = TipOf(editor_->link(free.link), free.end);
    index_.FindWithin(tip.point, task_.reach.Radius() * tip.footprint, &near_);
    for (const SpatialIndex::Neighbor& neighbor : near_) {
      const auto& [other, at] = places_.point[neighbor.index];
      const Eigen::Vector3d& place = places_.position[neighbor.index];
      const auto offset = task_.reach.To(tip, place);
      if (!offset) continue;
      const DrawingLink& link = editor_->link(other);
      const int last = link.size() - 1;
      const bool is_node = !link.closed && (at == 0 || at == last);
      const double cost_px =
          std::abs(offset->along_px) + 2 * offset->miss_px - (is_node ? kNodePreferencePx : 0);
      if (cost_px >= best.cost_px) continue;
      const NodeId node = is_node ? link.NodeAt(at == 0 ? 0 : 1) : -1;
      if (is_node ? !PartsFromAll(free, tip, node) : !Crosses(free, tip, other, at)) continue;
      best = {cost_px, node, other, at};
      best_place = place;
    }
    const bool is_small = (best_place - tip.point).norm() <= kSmallGapPx * tip.footprint;
    if (best.link < 0 || is_small || ImagesShow(free, best_place, best)) return best;
    ++task_.counts->refused;
    return {};
  }

  // Returns whether, at the node, the link would part from all links there. If the node is its own
  // other end, it must be long enough for a loop.
  bool PartsFromAll(const LinkEnd& free, const LinkTip& tip, NodeId id) const {
    const DrawingLink& own = editor_->link(free.link);
    const auto& incident = editor_->node(id).incident;
    return std::all_of(incident.begin(), incident.end(), [&](const LinkEnd& end) {
      if (end == free) return false;
      if (end.link == free.link && !MayClose(LengthPx(own), task_.reach.gap_px)) return false;
      const LinkTip other = TipOf(editor_->link(end.link), end.end, tip.footprint);
      return TurnBetween(other.outward, tip.outward) > min_parting_rad_;
    });
  }

  // Returns whether the place is in the interior of another link that does not run along the end.
  bool Crosses(const LinkEnd& free, const LinkTip& tip, LinkId other, int at) const {
    const DrawingLink& link = editor_->link(other);
    if (other == free.link) return false;
    if (!link.closed &&
        std::min(ArcPx(link, 0, at), ArcPx(link, at, link.size() - 1)) < kNodePreferencePx) {
      return false;
    }
    return LineAngleBetween(tip.outward, TangentAt(link, at)) > min_parting_rad_;
  }

  // That the end meets the link, or any of the node's.
  bool ImagesShow(const LinkEnd& free, const Eigen::Vector3d& place, const Target& target) const {
    const FragmentsByView own = FragmentsAtEnd(task_.input, editor_->link(free.link), free.end);
    const auto agree = [&](const FragmentsByView& of_other) {
      return ImagesAgree(task_.input, place, own, of_other, task_.options.min_junction_views);
    };
    if (target.node < 0) {
      return agree(FragmentsAround(task_.input, editor_->link(target.link), target.index));
    }
    const auto& incident = editor_->node(target.node).incident;
    return std::any_of(incident.begin(), incident.end(), [&](const LinkEnd& end) {
      return agree(FragmentsAtEnd(task_.input, editor_->link(end.link), end.end));
    });
  }

  // Splits each link from the back, so that indices before the cut stay valid. Nearby places share
  // a node.
  void CutLinks() {
    std::sort(cuts_.rbegin(), cuts_.rend());
    LinkId last_link = -1;
    int last_index = 0;
    NodeId node = -1;
    for (const auto& [link, index, from] : cuts_) {
      const bool is_near =
          link == last_link && (index == last_index ||
                                ArcPx(editor_->link(link), index, last_index) < kNodePreferencePx);
      if (!is_near) {
        node = editor_->Split(link, index);
        last_link = link;
        last_index = index;
      }
      moves_.push_back({from, node});
    }
  }

  struct Cut {
    LinkId link = -1;
    int index = -1;
    NodeId from = -1;

    auto operator<=>(const Cut&) const = default;
  };

  const MeetingTask& task_;
  GraphEditor* editor_;
  double min_parting_rad_;
  Places places_;
  SpatialIndex index_;
  std::vector<SpatialIndex::Neighbor> near_;
  std::vector<std::pair<NodeId, NodeId>> moves_;  // free node, its target
  std::vector<Cut> cuts_;
};

}  // namespace

void SnapEnds(const MeetingTask& task) {
  if (!task.editor->FreeEnds().empty()) EndSnapper(task).Run();
}

}  // namespace limn
