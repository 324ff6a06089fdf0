#include "limn/drawing/junctions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/drawing/vertex_grid.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
// How far an end may overshoot the meeting point, px: edges are rounded where they meet.
constexpr double kMaxOvershootPx = 6;
// Image curves must come this near to the projected meeting point, px.
constexpr double kEvidenceRadiusPx = 6;
// Stretch of a link that speaks for its end, px.
constexpr double kEndStretchPx = 12;
// A gap this small needs no evidence of its own.
constexpr double kSmallGapPx = 3;

struct LinkEndRef {
  int link = -1;
  int end = 0;
};

// The fragments, per view, that support a stretch of a link.
using FragmentsByView = std::map<ViewId, std::set<int>>;

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

class Joiner {
 public:
  Joiner(const SampleSet& samples, const std::vector<View>& views,
         const std::vector<std::unique_ptr<ViewEvidence>>& evidence, const DrawingOptions& options,
         Draft* draft)
      : samples_(samples), views_(views), evidence_(evidence), options_(options), draft_(draft) {}

  JunctionCounts Run() {
    JoinContinuations();
    JoinCorners();
    JoinToNodes();
    JoinToInteriors();
    return counts_;
  }

 private:
  DraftLink& LinkOf(const LinkEndRef& ref) { return draft_->links[ref.link]; }

  std::vector<LinkEndRef> FreeEnds() const {
    std::vector<LinkEndRef> ends;
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      if (draft_->links[i].closed || draft_->links[i].size() < 2) continue;
      for (const int end : {0, 1}) {
        if (draft_->links[i].node[end] < 0) ends.push_back({static_cast<int>(i), end});
      }
    }
    return ends;
  }

  double ReachPx() const { return options_.max_junction_gap_px + kMaxOvershootPx; }

  // Pairs (i < j) of ends within reach of each other.
  std::vector<std::pair<int, int>> NearPairs(const std::vector<LinkEndRef>& ends,
                                             const std::vector<EndLine>& lines) const {
    const double reach_px = 2 * ReachPx();
    VertexGrid grid(reach_px);
    for (size_t i = 0; i < ends.size(); ++i) {
      grid.Add(static_cast<int>(i), lines[i].point, lines[i].footprint);
    }
    std::vector<std::pair<int, int>> pairs;
    for (size_t i = 0; i < ends.size(); ++i) {
      grid.ForEachNear(lines[i].point, lines[i].footprint, [&](int j) {
        if (j <= static_cast<int>(i)) return;
        if ((lines[i].point - lines[j].point).norm() > reach_px * lines[i].footprint) return;
        pairs.push_back({static_cast<int>(i), j});
      });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  std::vector<EndLine> Lines(const std::vector<LinkEndRef>& ends) const {
    std::vector<EndLine> lines;
    for (const LinkEndRef& ref : ends) lines.push_back(LineAtEnd(draft_->links[ref.link], ref.end));
    return lines;
  }

  void CollectFragments(const DraftLink& link, int k, FragmentsByView* fragments) const {
    for (const int s : link.samples[k]) {
      for (const EdgelRef& ref : samples_.support.Of(s)) {
        (*fragments)[ref.view].insert(evidence_[ref.view]->fragment_of[ref.edgel]);
      }
    }
  }

  FragmentsByView FragmentsAround(const DraftLink& link, int index) const {
    FragmentsByView fragments;
    double arc = 0;
    for (int k = index; k >= 0 && arc <= kEndStretchPx; --k) {
      CollectFragments(link, k, &fragments);
      if (k > 0) arc += ArcPx(link, k - 1, k);
    }
    arc = 0;
    for (int k = index + 1; k < link.size() && arc <= kEndStretchPx; ++k) {
      CollectFragments(link, k, &fragments);
      arc += ArcPx(link, k - 1, k);
    }
    return fragments;
  }

  FragmentsByView FragmentsAtEnd(const LinkEndRef& ref) const {
    const DraftLink& link = draft_->links[ref.link];
    return FragmentsAround(link, ref.end == 0 ? 0 : link.size() - 1);
  }

  // Views in which image curves of both stretches come near the projection of the point.
  bool ImagesAgree(const Eigen::Vector3d& point, const FragmentsByView& a,
                   const FragmentsByView& b) const {
    int count = 0;
    for (const auto& [view, fragments_a] : a) {
      const auto found = b.find(view);
      if (found == b.end()) continue;
      const auto pixel = views_[view].Project(point);
      if (!pixel) continue;
      bool near_a = false;
      bool near_b = false;
      evidence_[view]->edgels.ForEachWithin(*pixel, kEvidenceRadiusPx, [&](EdgelId id) {
        const int fragment = evidence_[view]->fragment_of[id];
        near_a |= fragments_a.count(fragment) > 0;
        near_b |= found->second.count(fragment) > 0;
      });
      count += near_a && near_b;
    }
    return count >= options_.min_junction_views;
  }

  bool InReach(double along, double footprint) const {
    return along <= options_.max_junction_gap_px * footprint &&
           along >= -kMaxOvershootPx * footprint;
  }

  // --- ends that continue each other
  // -----------------------------------------------------------------

  // Cost of joining two ends into one link: the gap, px; nothing if they do not continue each
  // other.
  std::optional<double> ContinuationGap(const EndLine& a, const EndLine& b) const {
    if (a.outward.dot(b.outward) > -std::cos(options_.max_continuation_angle_deg * kDeg)) {
      return std::nullopt;
    }
    const Eigen::Vector3d offset = b.point - a.point;
    const double along_a = offset.dot(a.outward);
    const double along_b = -offset.dot(b.outward);
    if (!InReach(along_a, a.footprint) || !InReach(along_b, a.footprint)) return std::nullopt;
    const double miss = std::max((offset - along_a * a.outward).norm(),
                                 (offset - offset.dot(b.outward) * b.outward).norm());
    if (miss > options_.max_junction_miss_px * a.footprint) return std::nullopt;
    return offset.norm() / a.footprint;
  }

  void JoinContinuations() {
    const auto ends = FreeEnds();
    const auto lines = Lines(ends);
    std::vector<std::tuple<double, int, int>> candidates;
    for (const auto& [i, j] : NearPairs(ends, lines)) {
      const auto gap = ContinuationGap(lines[i], lines[j]);
      if (gap) candidates.push_back({*gap, i, j});
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<bool> used(ends.size(), false);
    // Ends joined in pairs; links are concatenated afterwards, along the chains of pairs.
    std::map<std::pair<int, int>, LinkEndRef> next;
    for (const auto& [gap, i, j] : candidates) {
      if (used[i] || used[j]) continue;
      const Eigen::Vector3d middle = 0.5 * (lines[i].point + lines[j].point);
      if (gap > kSmallGapPx &&
          !ImagesAgree(middle, FragmentsAtEnd(ends[i]), FragmentsAtEnd(ends[j]))) {
        ++counts_.without_image_evidence;
        continue;
      }
      used[i] = used[j] = true;
      next[{ends[i].link, ends[i].end}] = ends[j];
      next[{ends[j].link, ends[j].end}] = ends[i];
      ++counts_.continued;
    }
    Concatenate(next);
  }

  static void Append(const DraftLink& from, bool reversed, DraftLink* to) {
    const int size = from.size();
    for (int k = 0; k < size; ++k) {
      const int i = reversed ? size - 1 - k : k;
      to->position.push_back(from.position[i]);
      to->information.push_back(from.information[i]);
      to->footprint.push_back(from.footprint[i]);
      to->samples.push_back(from.samples[i]);
    }
  }

  // Drop points of an overshooting end so that the joint does not run back and forth.
  static void TrimJoint(DraftLink* link, const DraftLink& appended, bool reversed) {
    const Eigen::Vector3d& start = reversed ? appended.position.back() : appended.position.front();
    while (link->size() > 2) {
      const int last = link->size() - 1;
      const Eigen::Vector3d ahead = link->position[last] - link->position[last - 1];
      if ((start - link->position[last]).dot(ahead) > 0) break;
      link->position.pop_back();
      link->information.pop_back();
      link->footprint.pop_back();
      link->samples[last - 1].insert(link->samples[last - 1].end(), link->samples[last].begin(),
                                     link->samples[last].end());
      link->samples.pop_back();
    }
  }

  void Concatenate(const std::map<std::pair<int, int>, LinkEndRef>& next) {
    std::vector<uint8_t> done(draft_->links.size(), 0);
    std::vector<DraftLink> joined;
    const auto follow = [&](int start, int start_end) {
      // Leave `start` by the end opposite to start_end, and so on until the chain ends.
      DraftLink link;
      int current = start;
      int entered_by = start_end;
      bool loop = false;
      while (true) {
        done[current] = 1;
        const DraftLink& part = draft_->links[current];
        const bool reversed = entered_by == 1;
        if (link.size() > 0) TrimJoint(&link, part, reversed);
        if (link.size() == 0) link.node[0] = part.node[entered_by];
        Append(part, reversed, &link);
        link.node[1] = part.node[1 - entered_by];
        const auto step = next.find({current, 1 - entered_by});
        if (step == next.end()) break;
        if (done[step->second.link]) {
          loop = true;
          break;
        }
        current = step->second.link;
        entered_by = step->second.end;
      }
      link.closed = loop && link.size() > 2;
      joined.push_back(std::move(link));
    };
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      if (done[i]) continue;
      const int id = static_cast<int>(i);
      if (draft_->links[i].closed || (!next.count({id, 0}) && !next.count({id, 1}))) {
        done[i] = 1;
        joined.push_back(std::move(draft_->links[i]));
      } else if (!next.count({id, 0})) {
        follow(id, 0);
      } else if (!next.count({id, 1})) {
        follow(id, 1);
      }
    }
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      if (!done[i]) follow(static_cast<int>(i), 0);  // rings
    }
    draft_->links = std::move(joined);
  }

  // --- corners
  // ---------------------------------------------------------------------------------------

  void JoinCorners() {
    const auto ends = FreeEnds();
    const auto lines = Lines(ends);
    std::vector<std::tuple<double, int, int>> candidates;
    const double max_cosine = std::cos(options_.max_continuation_angle_deg * kDeg);
    for (const auto& [i, j] : NearPairs(ends, lines)) {
      if (ends[i].link == ends[j].link) continue;
      if (std::abs(lines[i].outward.dot(lines[j].outward)) > max_cosine) continue;
      const auto meeting = Meet(lines[i], lines[j]);
      const double footprint = lines[i].footprint;
      if (!meeting || !InReach(meeting->along_a, footprint) ||
          !InReach(meeting->along_b, footprint) ||
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
      if (!ImagesAgree(*point, FragmentsAtEnd(ends[i]), FragmentsAtEnd(ends[j]))) {
        ++counts_.without_image_evidence;
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
      for (const int i : group) EndAt(ends[i], node, point);
      ++counts_.corners;
    }
  }

  // The common corner of a set of ends, if all their lines pass it near enough, each with another
  // link.
  std::optional<Eigen::Vector3d> CornerOf(const std::vector<int>& group,
                                          const std::vector<LinkEndRef>& ends,
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
      if (!InReach(along, line.footprint)) return std::nullopt;
      if ((offset - along * line.outward).norm() > options_.max_junction_miss_px * line.footprint) {
        return std::nullopt;
      }
    }
    return point;
  }

  // Cut what overshoots the node, then end there.
  void EndAt(const LinkEndRef& ref, int node, const Eigen::Vector3d& point) {
    DraftLink& link = LinkOf(ref);
    const auto erase_tip = [&](auto* values) {
      values->erase(ref.end == 0 ? values->begin() : values->end() - 1);
    };
    while (link.size() > 2) {
      const int tip = ref.end == 0 ? 0 : link.size() - 1;
      const int before = ref.end == 0 ? 1 : link.size() - 2;
      const Eigen::Vector3d outward = link.position[tip] - link.position[before];
      if ((point - link.position[tip]).dot(outward) > 0) break;
      auto& kept = link.samples[before];
      kept.insert(kept.end(), link.samples[tip].begin(), link.samples[tip].end());
      erase_tip(&link.position);
      erase_tip(&link.information);
      erase_tip(&link.footprint);
      erase_tip(&link.samples);
    }
    const auto insert_tip = [&](auto* values, const auto& value) {
      auto copy = value;
      values->insert(ref.end == 0 ? values->begin() : values->end(), std::move(copy));
    };
    const int tip = ref.end == 0 ? 0 : link.size() - 1;
    insert_tip(&link.information, link.information[tip]);
    insert_tip(&link.footprint, link.footprint[tip]);
    insert_tip(&link.samples, std::vector<int>());
    insert_tip(&link.position, point);
    link.node[ref.end] = node;
  }

  // --- ends at nodes and inside links
  // ----------------------------------------------------------------

  void JoinToNodes() {
    std::map<int, std::vector<LinkEndRef>> at_node;
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      for (const int end : {0, 1}) {
        const int node = draft_->links[i].node[end];
        if (node >= 0) at_node[node].push_back({static_cast<int>(i), end});
      }
    }
    for (const LinkEndRef& ref : FreeEnds()) {
      const EndLine line = LineAtEnd(LinkOf(ref), ref.end);
      int best = -1;
      double best_distance = std::numeric_limits<double>::infinity();
      for (const auto& [node, incident] : at_node) {
        const auto distance = DistanceToNode(ref, line, NodePosition(incident));
        if (distance && *distance < best_distance) {
          best = node;
          best_distance = *distance;
        }
      }
      if (best < 0) continue;
      const Eigen::Vector3d point = NodePosition(at_node[best]);
      bool agree = false;
      for (const LinkEndRef& other : at_node[best]) {
        agree |= other.link != ref.link &&
                 ImagesAgree(point, FragmentsAtEnd(ref), FragmentsAtEnd(other));
      }
      if (!agree) {
        ++counts_.without_image_evidence;
        continue;
      }
      EndAt(ref, best, point);
      at_node[best].push_back(ref);
      ++counts_.joined_nodes;
    }
  }

  Eigen::Vector3d NodePosition(const std::vector<LinkEndRef>& incident) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const LinkEndRef& ref : incident) {
      const DraftLink& link = draft_->links[ref.link];
      sum += ref.end == 0 ? link.position.front() : link.position.back();
    }
    return sum / static_cast<double>(incident.size());
  }

  std::optional<double> DistanceToNode(const LinkEndRef& ref, const EndLine& line,
                                       const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - line.point;
    if (offset.norm() > ReachPx() * line.footprint) return std::nullopt;
    const double along = offset.dot(line.outward);
    if (!InReach(along, line.footprint)) return std::nullopt;
    const double miss = (offset - along * line.outward).norm();
    if (miss > options_.max_junction_miss_px * line.footprint) return std::nullopt;
    // A link's own node at its other end is no place to end at, unless the link is long.
    const DraftLink& link = draft_->links[ref.link];
    if (LengthPx(link) < 2 * ReachPx()) {
      const Eigen::Vector3d& other = ref.end == 0 ? link.position.back() : link.position.front();
      if ((other - point).norm() < line.footprint) return std::nullopt;
    }
    return offset.norm();
  }

  void JoinToInteriors() {
    VertexGrid grid(ReachPx());
    std::vector<std::pair<int, int>> places;
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      const DraftLink& link = draft_->links[i];
      for (int k = 0; k < link.size(); ++k) {
        grid.Add(static_cast<int>(places.size()), link.position[k], link.footprint[k]);
        places.push_back({static_cast<int>(i), k});
      }
    }
    struct Target {
      LinkEndRef from;
      Eigen::Vector3d point;
    };
    std::map<std::pair<int, int>, std::vector<Target>> targets;  // by (link, index)
    for (const LinkEndRef& ref : FreeEnds()) {
      const auto place = BestInterior(ref, grid, places);
      if (!place) continue;
      const DraftLink& link = draft_->links[place->first];
      const Eigen::Vector3d& point = link.position[place->second];
      if (!ImagesAgree(point, FragmentsAtEnd(ref), FragmentsAround(link, place->second))) {
        ++counts_.without_image_evidence;
        continue;
      }
      targets[*place].push_back({ref, point});
      ++counts_.t_junctions;
    }
    // First all cuts, from the back of each link so that the indices in front stay valid; only then
    // are ends moved, which changes indices.
    std::vector<int> nodes;
    int previous_link = -1;
    int shift = 0;
    for (auto it = targets.rbegin(); it != targets.rend(); ++it) {
      const auto& [link, index] = it->first;
      if (link != previous_link) shift = 0;
      previous_link = link;
      const int node = draft_->num_nodes++;
      if (draft_->links[link].closed) {
        // What was in front of the cut now follows it.
        shift = draft_->links[link].size() - index;
        OpenLoop(index, node, &draft_->links[link]);
      } else {
        const int new_link = static_cast<int>(draft_->links.size());
        SplitLink(draft_, link, index + shift, node);
        // An end of the cut link that waits to be joined elsewhere moves to the new part.
        for (auto& [place, waiting] : targets) {
          for (auto& target : waiting) {
            if (target.from.link == link && target.from.end == 1) target.from.link = new_link;
          }
        }
      }
      nodes.push_back(node);
    }
    size_t joint = 0;
    for (auto it = targets.rbegin(); it != targets.rend(); ++it, ++joint) {
      for (const Target& target : it->second) EndAt(target.from, nodes[joint], target.point);
    }
  }

  // A loop with a junction begins and ends at it.
  void OpenLoop(int index, int node, DraftLink* loop) {
    const auto rotate = [&](auto* values) {
      std::rotate(values->begin(), values->begin() + index, values->end());
      values->push_back(values->front());
    };
    rotate(&loop->position);
    rotate(&loop->information);
    rotate(&loop->footprint);
    rotate(&loop->samples);
    loop->samples.back().clear();
    loop->closed = false;
    loop->node[0] = loop->node[1] = node;
  }

  std::optional<std::pair<int, int>> BestInterior(
      const LinkEndRef& ref, const VertexGrid& grid,
      const std::vector<std::pair<int, int>>& places) const {
    const EndLine line = LineAtEnd(draft_->links[ref.link], ref.end);
    const double max_cosine = std::cos(options_.max_continuation_angle_deg * kDeg);
    std::optional<std::pair<int, int>> best;
    double best_cost = std::numeric_limits<double>::infinity();
    grid.ForEachNear(line.point, line.footprint, [&](int id) {
      const auto& [link_id, k] = places[id];
      const DraftLink& link = draft_->links[link_id];
      if (link_id == ref.link || k == 0 || k + 1 == link.size()) return;
      const Eigen::Vector3d offset = link.position[k] - line.point;
      const double along = offset.dot(line.outward);
      if (!InReach(along, line.footprint)) return;
      const double miss = (offset - along * line.outward).norm();
      if (miss > options_.max_junction_miss_px * line.footprint) return;
      const Eigen::Vector3d tangent = (link.position[k + 1] - link.position[k - 1]).normalized();
      if (std::abs(tangent.dot(line.outward)) > max_cosine) return;
      const double cost = offset.norm() + miss;
      if (cost < best_cost || (cost == best_cost && places[id] < *best)) {
        best_cost = cost;
        best = places[id];
      }
    });
    return best;
  }

  const SampleSet& samples_;
  const std::vector<View>& views_;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence_;
  const DrawingOptions& options_;
  Draft* draft_;
  JunctionCounts counts_;
};

}  // namespace

JunctionCounts JoinLinks(const SampleSet& samples, const std::vector<View>& views,
                         const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                         const DrawingOptions& options, Draft* draft) {
  return Joiner(samples, views, evidence, options, draft).Run();
}

}  // namespace limn
