#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "limn/drawing/junctions.h"
#include "limn/drawing/vertex_grid.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;

class EndJoiner {
 public:
  EndJoiner(const DrawingOptions& options, LinkEnds& ends, Draft* draft, JunctionCounts* counts)
      : options_(options), ends_(ends), draft_(draft), counts_(counts) {}

  void ToNodes() {
    EndsAtNode at_node = CollectEnds(*draft_);
    VertexGrid grid(ends_.ReachPx());
    for (const auto& [node, incident] : at_node) {
      const DraftLink& link = draft_->links[incident[0].link];
      const double footprint =
          incident[0].end == 0 ? link.footprint.front() : link.footprint.back();
      grid.Add(node, NodePosition(incident), footprint);
    }
    for (const LinkEnd& ref : ends_.Free()) {
      const EndLine line = LineAtEnd(draft_->links[ref.link], ref.end);
      int best = -1;
      double best_distance = std::numeric_limits<double>::infinity();
      grid.ForEachNear(line.point, line.footprint, [&](int node) {
        const auto distance = DistanceToNode(ref, line, NodePosition(at_node[node]));
        if (!distance || std::pair(*distance, node) >= std::pair(best_distance, best)) return;
        best = node;
        best_distance = *distance;
      });
      if (best < 0) continue;
      const Eigen::Vector3d point = NodePosition(at_node[best]);
      bool agree = false;
      for (const LinkEnd& other : at_node[best]) {
        agree |= other.link != ref.link &&
                 ends_.ImagesAgree(point, ends_.FragmentsAtEnd(ref), ends_.FragmentsAtEnd(other));
      }
      if (!agree) {
        ++counts_->without_image_evidence;
        continue;
      }
      ends_.EndAt(ref, best, point);
      at_node[best].push_back(ref);
      ++counts_->joined_nodes;
    }
  }

  void ToInteriors() {
    VertexGrid grid(ends_.ReachPx());
    std::vector<std::pair<int, int>> places;
    for (size_t i = 0; i < draft_->links.size(); ++i) {
      const DraftLink& link = draft_->links[i];
      for (int k = 0; k < link.size(); ++k) {
        grid.Add(static_cast<int>(places.size()), link.position[k], link.footprint[k]);
        places.push_back({static_cast<int>(i), k});
      }
    }
    struct Target {
      LinkEnd from;
      Eigen::Vector3d point;
    };
    std::map<std::pair<int, int>, std::vector<Target>> targets;  // by (link, index)
    for (const LinkEnd& ref : ends_.Free()) {
      const auto place = BestInterior(ref, grid, places);
      if (!place) continue;
      const DraftLink& link = draft_->links[place->first];
      const Eigen::Vector3d& point = link.position[place->second];
      if (!ends_.ImagesAgree(point, ends_.FragmentsAtEnd(ref),
                             ends_.FragmentsAround(link, place->second))) {
        ++counts_->without_image_evidence;
        continue;
      }
      targets[*place].push_back({ref, point});
      ++counts_->t_junctions;
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
      for (const Target& target : it->second) ends_.EndAt(target.from, nodes[joint], target.point);
    }
  }

 private:
  Eigen::Vector3d NodePosition(const std::vector<LinkEnd>& incident) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const LinkEnd& ref : incident) {
      const DraftLink& link = draft_->links[ref.link];
      sum += ref.end == 0 ? link.position.front() : link.position.back();
    }
    return sum / static_cast<double>(incident.size());
  }

  std::optional<double> DistanceToNode(const LinkEnd& ref, const EndLine& line,
                                       const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - line.point;
    if (offset.norm() > ends_.ReachPx() * line.footprint) return std::nullopt;
    const double along = offset.dot(line.outward);
    if (!ends_.InReach(along, line.footprint)) return std::nullopt;
    const double miss = (offset - along * line.outward).norm();
    if (miss > options_.max_junction_miss_px * line.footprint) return std::nullopt;
    // A link's own node at its other end is no place to end at, unless the link is long.
    const DraftLink& link = draft_->links[ref.link];
    if (LengthPx(link) < 2 * ends_.ReachPx()) {
      const Eigen::Vector3d& other = ref.end == 0 ? link.position.back() : link.position.front();
      if ((other - point).norm() < line.footprint) return std::nullopt;
    }
    return offset.norm();
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
      const LinkEnd& ref, const VertexGrid& grid,
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
      if (!ends_.InReach(along, line.footprint)) return;
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

  const DrawingOptions& options_;
  LinkEnds& ends_;
  Draft* draft_;
  JunctionCounts* counts_;
};

}  // namespace

void JoinToNodes(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                 JunctionCounts* counts) {
  EndJoiner(options, ends, draft, counts).ToNodes();
}

void JoinToInteriors(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                     JunctionCounts* counts) {
  EndJoiner(options, ends, draft, counts).ToInteriors();
}

}  // namespace limn
