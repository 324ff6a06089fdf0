#include <algorithm>
#include <cmath>
#include <tuple>

#include "limn/geometry/spatial_index.h"
#include "limn/refinement/topology_edits.h"

namespace limn {
namespace {

class EndJoining {
 public:
  explicit EndJoining(GraphEditor* editor)
      : editor_(editor), ends_(editor->FreeEnds()), keep_(editor->graph().links.size(), 1) {
    for (const LinkEnd& end : ends_) {
      tips_.push_back(editor->Tip(end));
      points_.push_back(tips_.back().point);
    }
  }

  int64_t Run() {
    int64_t num_joined = 0;
    std::vector<uint8_t> used(ends_.size(), 0);
    for (const auto& [px, i, j] : FindPairs()) {
      if (used[i] || used[j]) continue;
      used[i] = used[j] = 1;
      Join(i, j);
      ++num_joined;
    }
    editor_->Keep(keep_);
    return num_joined;
  }

 private:
  // Gap, px, and two ends, by gap.
  using Pair = std::tuple<double, int, int>;

  std::vector<Pair> FindPairs() const {
    std::vector<Pair> pairs;
    const SpatialIndex index(points_);
    std::vector<SpatialIndex::Neighbor> near;
    for (int i = 0; i < static_cast<int>(ends_.size()); ++i) {
      const double footprint = editor_->FootprintOf(ends_[i].link);
      index.FindWithin(points_[i], (kMaxGapPx + kMaxMissPx) * footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        const int j = neighbor.index;
        const double px = std::sqrt(neighbor.squared_distance) / footprint;
        if (j > i && GoesOn(i, j, px, footprint)) pairs.push_back({px, i, j});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  bool GoesOn(int i, int j, double px, double footprint) const {
    const double turn = AngleBetween(tips_[i].outward, -tips_[j].outward);
    if (turn > kMaxTurnRad) return false;
    if (!editor_->Reaches(tips_[i], points_[j], footprint, turn)) return false;
    if (!editor_->Reaches(tips_[j], points_[i], footprint, turn)) return false;
    const LinkId a = ends_[i].link;
    const LinkId b = ends_[j].link;
    // A loop is much longer than the gap it leaves.
    const double length_px = static_cast<double>(editor_->link(a).points_in_world.size());
    if (a == b && length_px < 4 * kMaxGapPx) return false;
    return px <= kSmallGapPx || editor_->ImagesShow(points_[i], points_[j], a, b);
  }

  void Join(int i, int j) {
    const LinkEnd a = moves_.Now(ends_[i]);
    const LinkEnd b = moves_.Now(ends_[j]);
    DropOvershoot(a, points_[j]);
    JoinEnds(a, b, &editor_->graph());
    if (a.link == b.link) return;
    keep_[b.link] = 0;
    moves_.Joined(a, b);
  }

  // Points of an end beyond the place, seen along the end.
  void DropOvershoot(const LinkEnd& end, const Eigen::Vector3d& place) {
    const auto& points = editor_->link(end.link).points_in_world;
    const int size = static_cast<int>(points.size());
    const Eigen::Vector3d outward = editor_->Tip(end).outward;
    int drop = 0;
    while (drop + 3 < size) {
      const Eigen::Vector3d& point = points[end.end == 0 ? drop : size - 1 - drop];
      if ((place - point).dot(outward) > 0) break;
      ++drop;
    }
    if (drop == 0) return;
    editor_->CutTo(end.end == 0 ? drop : 0, end.end == 0 ? size : size - drop, end.link);
  }

  GraphEditor* editor_;
  std::vector<LinkEnd> ends_;
  std::vector<LinkTip> tips_;
  std::vector<Eigen::Vector3d> points_;
  EndMoves moves_;
  std::vector<uint8_t> keep_;
};

}  // namespace

int64_t JoinAlignedEnds(GraphEditor* editor) {
  if (editor->FreeEnds().empty()) return 0;
  return EndJoining(editor).Run();
}

}  // namespace limn
