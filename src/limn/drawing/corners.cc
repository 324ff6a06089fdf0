#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/drawing/junctions.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;

// Meeting of two lines: parameters along their outward directions and the miss between them.
struct Meeting {
  double along_a = 0;
  double along_b = 0;
  double miss = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

std::optional<Meeting> Meet(const EndLine& a, const EndLine& b) {
  const double cosine = a.outward.dot(b.outward);
  const double determinant = 1 - cosine * cosine;
  if (!(determinant > 1e-6)) return std::nullopt;
  const Eigen::Vector3d offset = b.point - a.point;
  Meeting meeting;
  meeting.along_a = (offset.dot(a.outward) - cosine * offset.dot(b.outward)) / determinant;
  meeting.along_b = (cosine * offset.dot(a.outward) - offset.dot(b.outward)) / determinant;
  const Eigen::Vector3d on_a = a.point + meeting.along_a * a.outward;
  const Eigen::Vector3d on_b = b.point + meeting.along_b * b.outward;
  meeting.miss = (on_a - on_b).norm();
  meeting.point = 0.5 * (on_a + on_b);
  return meeting;
}

// The point nearest to a set of lines; nothing if they are parallel.
std::optional<Eigen::Vector3d> IntersectLines(const std::vector<EndLine>& lines) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const EndLine& line : lines) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - line.outward * line.outward.transpose();
    sum += across;
    right += across * line.point;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(sum);
  if (!(std::abs(solver.determinant()) > 1e-4)) return std::nullopt;
  return solver.solve(right);
}

class CornerJoiner {
 public:
  CornerJoiner(const DrawingOptions& options, LinkEnds& ends, Draft* draft, JunctionCounts* counts)
      : options_(options), ends_(ends), draft_(draft), counts_(counts) {}

  void Run() {
    const auto ends = ends_.Free();
    const auto lines = ends_.Lines(ends);
    std::vector<std::tuple<double, int, int>> candidates;
    const double max_cosine = std::cos(options_.max_continuation_angle_deg * kDeg);
    for (const auto& [i, j] : ends_.NearPairs(lines)) {
      if (ends[i].link == ends[j].link) continue;
      if (std::abs(lines[i].outward.dot(lines[j].outward)) > max_cosine) continue;
      const auto meeting = Meet(lines[i], lines[j]);
      const double footprint = lines[i].footprint;
      if (!meeting || !ends_.InReach(meeting->along_a, footprint) ||
          !ends_.InReach(meeting->along_b, footprint) ||
          meeting->miss > options_.max_junction_miss_px * footprint) {
        continue;
      }
      candidates.push_back(
          {(std::abs(meeting->along_a) + std::abs(meeting->along_b) + meeting->miss) / footprint, i,
           j});
    }
    std::sort(candidates.begin(), candidates.end());
    UnionFind groups(static_cast<int>(ends.size()));
    std::map<int, std::vector<int>> members;
    for (size_t i = 0; i < ends.size(); ++i) members[static_cast<int>(i)] = {static_cast<int>(i)};
    for (const auto& [cost, i, j] : candidates) {
      const int a = groups.Find(i);
      const int b = groups.Find(j);
      if (a == b) continue;
      std::vector<int> together = members[a];
      together.insert(together.end(), members[b].begin(), members[b].end());
      const auto point = CornerOf(together, ends, lines);
      if (!point) continue;
      if (!ends_.ImagesAgree(*point, ends_.FragmentsAtEnd(ends[i]),
                             ends_.FragmentsAtEnd(ends[j]))) {
        ++counts_->without_image_evidence;
        continue;
      }
      groups.Union(a, b);
      members.erase(std::max(a, b));
      std::sort(together.begin(), together.end());
      members[std::min(a, b)] = std::move(together);
    }
    for (const auto& [root, group] : members) {
      if (group.size() < 2) continue;
      const int node = draft_->num_nodes++;
      const Eigen::Vector3d point = *CornerOf(group, ends, lines);
      for (const int i : group) ends_.EndAt(ends[i], node, point);
      ++counts_->corners;
    }
  }

 private:
  // The common corner of a set of ends, if all their lines pass it near enough, each with another
  // link.
  std::optional<Eigen::Vector3d> CornerOf(const std::vector<int>& group,
                                          const std::vector<LinkEnd>& ends,
                                          const std::vector<EndLine>& lines) const {
    std::vector<EndLine> of_group;
    std::set<std::pair<int, int>> distinct;
    for (const int i : group) {
      of_group.push_back(lines[i]);
      distinct.insert({ends[i].link, 0});
    }
    if (distinct.size() != group.size()) return std::nullopt;
    const auto point = IntersectLines(of_group);
    if (!point) return std::nullopt;
    for (const EndLine& line : of_group) {
      const Eigen::Vector3d offset = *point - line.point;
      const double along = offset.dot(line.outward);
      if (!ends_.InReach(along, line.footprint)) return std::nullopt;
      if ((offset - along * line.outward).norm() > options_.max_junction_miss_px * line.footprint) {
        return std::nullopt;
      }
    }
    return point;
  }

  const DrawingOptions& options_;
  LinkEnds& ends_;
  Draft* draft_;
  JunctionCounts* counts_;
};

}  // namespace

void JoinCorners(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                 JunctionCounts* counts) {
  CornerJoiner(options, ends, draft, counts).Run();
}

}  // namespace limn
