// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/join_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/LU>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/spatial_index.h"
#include "limn/topology/arc_or_corner.h"
#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Shortest loop, px, and shortest loop relative to the gap it closes.
constexpr double kMinLoopPx = 16;
constexpr double kLoopOverGap = 4;

// The free ends of all links with vertices, and their tips.
struct FreeTips {
  explicit FreeTips(const GraphEditor& editor) {
    for (const LinkEnd& end : editor.FreeEnds()) {
      if (editor.link(end.link).vertices.empty()) continue;
      ends.push_back(end);
      tips.push_back(TipOf(editor.link(end.link), end.end));
      points.push_back(tips.back().point);
    }
  }

  // Pairs i < j within the radius.
  std::vector<std::pair<int, int>> NearPairs(double radius_px) const {
    std::vector<std::pair<int, int>> pairs;
    if (ends.empty()) return pairs;
    const SpatialIndex index(points);
    std::vector<SpatialIndex::Neighbor> near;
    for (int i = 0; i < static_cast<int>(ends.size()); ++i) {
      index.FindWithin(points[i], radius_px * tips[i].footprint, &near);
      for (const SpatialIndex::Neighbor& neighbor : near) {
        if (neighbor.index > i) pairs.push_back({i, neighbor.index});
      }
    }
    return pairs;
  }

  std::vector<LinkEnd> ends;
  std::vector<LinkTip> tips;
  std::vector<Eigen::Vector3d> points;
};

// The point nearest to a set of lines; empty if they are parallel.
std::optional<Eigen::Vector3d> IntersectLines(const std::vector<LinkTip>& lines) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const LinkTip& line : lines) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - line.outward * line.outward.transpose();
    sum += across;
    right += across * line.point;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(sum);
  if (!(std::abs(solver.determinant()) > 1e-4)) return std::nullopt;
  return solver.solve(right);
}

// Counts a refusal.
bool ImagesShowMeeting(const MeetingTask& task, const Eigen::Vector3d& point, const LinkEnd& a,
                       const LinkEnd& b) {
  const auto fragments = [&](const LinkEnd& end) {
    return FragmentsAtEnd(task.input, task.editor->link(end.link), end.end);
  };
  const bool shown =
      ImagesAgree(task.input, point, fragments(a), fragments(b), task.options.min_junction_views);
  task.counts->refused += !shown;
  return shown;
}

class CornerJoiner {
 public:
  explicit CornerJoiner(const MeetingTask& task) : task_(task), free_(*task.editor) {}

  void Run() {
    UnionFind sets(static_cast<int>(free_.ends.size()));
    std::vector<std::vector<int>> members(free_.ends.size());
    for (size_t i = 0; i < members.size(); ++i) members[i] = {static_cast<int>(i)};
    for (const auto& [cost, i, j] : Candidates()) {
      const int a = sets.Find(i);
      const int b = sets.Find(j);
      if (a == b) continue;
      std::vector<int> together = members[a];
      together.insert(together.end(), members[b].begin(), members[b].end());
      std::sort(together.begin(), together.end());
      const auto point = CornerOf(together);
      if (!point) continue;
      if (!ImagesShowMeeting(task_, *point, free_.ends[i], free_.ends[j])) continue;
      sets.Union(a, b);
      members[a].clear();
      members[b].clear();
      members[sets.Find(a)] = std::move(together);
    }
    for (const std::vector<int>& group : members) {
      if (group.size() > 1) Meet(group);
    }
  }

 private:
  using Candidate = std::tuple<double, int, int>;  // cost, px, and two ends

  std::vector<Candidate> Candidates() const {
    std::vector<Candidate> candidates;
    const double max_cosine = std::cos(task_.options.max_continuation_angle_deg * kDeg);
    for (const auto& [i, j] : free_.NearPairs(2 * task_.reach.Radius())) {
      const LinkTip& a = free_.tips[i];
      const LinkTip& b = free_.tips[j];
      if (free_.ends[i].link == free_.ends[j].link) continue;
      if (std::abs(a.outward.dot(b.outward)) > max_cosine) continue;
      const auto point = CornerOf({i, j});
      if (!point) continue;
      const auto from_a = task_.reach.To(a, *point);
      const auto from_b = task_.reach.To(b, *point);
      const double miss_px = from_a->miss_px + from_b->miss_px;  // from line to line
      if (miss_px > task_.reach.miss_px) continue;
      candidates.push_back(
          {std::abs(from_a->along_px) + std::abs(from_b->along_px) + miss_px, i, j});
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
  }

  // The common corner of a set of ends of different links, if it is in reach of each of them.
  std::optional<Eigen::Vector3d> CornerOf(const std::vector<int>& group) const {
    std::vector<LinkTip> lines;
    std::set<LinkId> links;
    for (const int i : group) {
      lines.push_back(free_.tips[i]);
      links.insert(free_.ends[i].link);
    }
    if (links.size() != group.size()) return std::nullopt;
    const auto point = IntersectLines(lines);
    const bool reached = point && std::all_of(lines.begin(), lines.end(), [&](const LinkTip& line) {
                           return task_.reach.To(line, *point).has_value();
                         });
    return reached ? point : std::nullopt;
  }

  void Meet(const std::vector<int>& group) {
    const Eigen::Vector3d corner = *CornerOf(group);
    std::vector<LinkEnd> ends;
    for (const int i : group) ends.push_back(task_.editor->CurrentEnd(free_.ends[i]));
    // Joined by an arc at their other ends since.
    const double gap_px =
        (free_.points[group[1]] - free_.points[group[0]]).norm() / free_.tips[group[0]].footprint;
    if (ends[0].link == ends[1].link &&
        !MayClose(LengthPx(task_.editor->link(ends[0].link)), gap_px)) {
      return;
    }
    const auto arc = group.size() == 2
                         ? ArcInsteadOfCorner(task_.input, *task_.editor, ends[0], ends[1], corner)
                         : std::nullopt;
    if (arc) {
      JoinByArc(*arc, ends[0], ends[1]);
    } else {
      const NodeId node = task_.editor->AddNode(corner);
      for (const LinkEnd& end : ends) task_.editor->EndAt(end, node);
      ++task_.counts->corners;
    }
  }

  void JoinByArc(const Polyline3d& arc, const LinkEnd& a, const LinkEnd& b) {
    for (size_t k = 1; k + 1 < arc.size(); ++k) {
      task_.editor->EndAt(a, task_.editor->AddNode(arc[k]));
    }
    task_.editor->Join(a, b);
    ++task_.counts->joined;
  }

  const MeetingTask& task_;
  FreeTips free_;
};

}  // namespace

bool MayClose(double length_px, double gap_px) {
  return length_px >= std::max(kMinLoopPx, kLoopOverGap * gap_px);
}

void JoinFacingEnds(const MeetingTask& task) {
  const FreeTips free(*task.editor);
  std::vector<std::tuple<double, int, int>> candidates;  // gap, px, and two ends
  for (const auto& [i, j] : free.NearPairs(task.reach.Radius())) {
    const LinkTip& a = free.tips[i];
    const LinkTip& b = free.tips[j];
    if (TurnBetween(a, b) > task.options.max_continuation_angle_deg * kDeg) continue;
    const double turn = TurnBetween(a.outward, -b.outward);
    if (!task.reach.To(a, b.point, turn) || !task.reach.To(b, a.point, turn)) continue;
    candidates.push_back({(b.point - a.point).norm() / a.footprint, i, j});
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<uint8_t> used(free.ends.size(), 0);
  for (const auto& [gap_px, i, j] : candidates) {
    if (used[i] || used[j]) continue;
    const LinkEnd a = task.editor->CurrentEnd(free.ends[i]);
    const LinkEnd b = task.editor->CurrentEnd(free.ends[j]);
    if (a.link == b.link && !MayClose(LengthPx(task.editor->link(a.link)), gap_px)) continue;
    if (gap_px > kSmallGapPx &&
        !ImagesShowMeeting(task, 0.5 * (free.points[i] + free.points[j]), a, b)) {
      continue;
    }
    used[i] = used[j] = 1;
    task.editor->DropOvershoot(a, EndPoint(task.editor->link(b.link), b.end));
    task.editor->Join(a, b);
    ++task.counts->joined;
  }
  task.editor->Compact();
}

void JoinCorners(const MeetingTask& task) {
  CornerJoiner(task).Run();
  task.editor->Compact();
}

}  // namespace limn
