#include <algorithm>
#include <cmath>
#include <set>

#include "limn/drawing/forks.h"
#include "limn/drawing/graph_assembly.h"
#include "limn/drawing/vertex_grid.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
// A link is covered when this share of its points runs along others.
constexpr double kCoveredShare = 0.8;
// Links between two nodes may be short, px.
constexpr double kMinBridgePx = 2;

void Reverse(DraftLink* link) {
  std::reverse(link->position.begin(), link->position.end());
  std::reverse(link->information.begin(), link->information.end());
  std::reverse(link->footprint.begin(), link->footprint.end());
  std::reverse(link->samples.begin(), link->samples.end());
  std::swap(link->node[0], link->node[1]);
}

template <typename T>
void AppendTail(const std::vector<T>& from, std::vector<T>* to) {
  to->insert(to->end(), from.begin() + 1, from.end());
}

// Nodes where two links continue each other, or a link itself, dissolve.
class NodeCleaner {
 public:
  NodeCleaner(const DrawingOptions& options, Draft* draft)
      : options_(options),
        draft_(draft),
        ends_(CollectEnds(*draft)),
        alive_(draft->links.size(), 1) {}

  int64_t Run() {
    int64_t dissolved = 0;
    std::set<int> waiting;
    for (const auto& [node, ends] : ends_) waiting.insert(node);
    while (!waiting.empty()) {
      const int node = *waiting.begin();
      waiting.erase(waiting.begin());
      const std::vector<LinkEnd> ends = ends_.at(node);
      if (ends.size() == 2 && ends[0].link == ends[1].link) {
        CloseLoop(ends[0].link);
        ends_.erase(node);
      } else if (ends.size() == 2 && Continue(ends[0], ends[1])) {
        Fuse(ends[0], ends[1]);
        ends_.erase(node);
        ++dissolved;
        // The fused link may now close a loop or continue another one.
        for (const int far : draft_->links[ends[0].link].node) {
          if (far >= 0) waiting.insert(far);
        }
      }
    }
    KeepLinks(alive_, draft_);
    return dissolved;
  }

 private:
  bool Continue(const LinkEnd& a, const LinkEnd& b) const {
    const EndLine line_a = LineAtEnd(draft_->links[a.link], a.end);
    const EndLine line_b = LineAtEnd(draft_->links[b.link], b.end);
    return line_a.outward.dot(line_b.outward) <
           -std::cos(options_.max_continuation_angle_deg * kDeg);
  }

  void CloseLoop(int id) {
    DraftLink& link = draft_->links[id];
    link.node[0] = link.node[1] = -1;
    if (link.size() < 4) return;
    // The last point repeats the first.
    link.samples.front().insert(link.samples.front().end(), link.samples.back().begin(),
                                link.samples.back().end());
    link.position.pop_back();
    link.information.pop_back();
    link.footprint.pop_back();
    link.samples.pop_back();
    link.closed = true;
  }

  // An end at a node is now that of another link.
  void Relabel(int node, const LinkEnd& from, const LinkEnd& to) {
    if (node < 0) return;
    std::vector<LinkEnd>& ends = ends_.at(node);
    std::replace(ends.begin(), ends.end(), from, to);
    std::sort(ends.begin(), ends.end());
  }

  // The second link becomes the tail of the first.
  void Fuse(const LinkEnd& a, const LinkEnd& b) {
    DraftLink& first = draft_->links[a.link];
    DraftLink& second = draft_->links[b.link];
    if (a.end == 0) {
      Relabel(first.node[1], {a.link, 1}, {a.link, 0});
      Reverse(&first);
    }
    Relabel(second.node[1 - b.end], {b.link, 1 - b.end}, {a.link, 1});
    if (b.end == 1) Reverse(&second);
    first.samples.back().insert(first.samples.back().end(), second.samples.front().begin(),
                                second.samples.front().end());
    AppendTail(second.position, &first.position);
    AppendTail(second.information, &first.information);
    AppendTail(second.footprint, &first.footprint);
    AppendTail(second.samples, &first.samples);
    first.node[1] = second.node[1];
    first.grown &= second.grown;
    alive_[b.link] = 0;
  }

  const DrawingOptions& options_;
  Draft* draft_;
  EndsAtNode ends_;
  std::vector<uint8_t> alive_;
};

// All but the links that hang by one end or by none and are shorter than the limit.
std::vector<uint8_t> LongOrTied(const DrawingOptions& options, const Draft& draft) {
  const EndsAtNode ends = CollectEnds(draft);
  const auto tied = [&](int node) { return node >= 0 && ends.at(node).size() > 1; };
  std::vector<uint8_t> keep;
  for (const DraftLink& link : draft.links) {
    const bool both_tied = tied(link.node[0]) && tied(link.node[1]);
    const bool bridge = both_tied && link.node[0] != link.node[1];
    const bool rooted = link.grown && (tied(link.node[0]) || tied(link.node[1]));
    const double needed = bridge || rooted ? kMinBridgePx : options.min_link_length_px;
    keep.push_back(link.size() >= 2 && LengthPx(link) >= needed);
  }
  return keep;
}

// Shorter links that run along longer ones.
class CoverageCheck {
 public:
  CoverageCheck(const DrawingOptions& options, const Draft& draft)
      : options_(options), draft_(draft), grid_(2 * options.merge_distance_px) {
    for (size_t i = 0; i < draft.links.size(); ++i) {
      const DraftLink& link = draft.links[i];
      for (int k = 0; k < link.size(); ++k) {
        grid_.Add(static_cast<int>(places_.size()), link.position[k], link.footprint[k]);
        places_.push_back({static_cast<int>(i), k});
      }
    }
  }

  std::vector<uint8_t> NotCovered() const {
    std::vector<std::pair<double, int>> order;
    for (size_t i = 0; i < draft_.links.size(); ++i) {
      order.push_back({LengthPx(draft_.links[i]), static_cast<int>(i)});
    }
    std::sort(order.begin(), order.end());
    std::vector<uint8_t> keep(draft_.links.size(), 1);
    for (const auto& [length, id] : order) {
      if (Covered(id, keep)) keep[id] = 0;
    }
    return keep;
  }

 private:
  bool Covered(int id, const std::vector<uint8_t>& keep) const {
    const DraftLink& link = draft_.links[id];
    const double min_cosine = std::cos(options_.max_link_angle_deg * kDeg);
    int covered = 0;
    for (int k = 0; k < link.size(); ++k) {
      const double footprint = link.footprint[k];
      const double radius = 2 * options_.merge_distance_px * footprint;
      const Eigen::Vector3d direction = TangentAt(link, k);
      bool found = false;
      grid_.ForEachNear(link.position[k], footprint, [&](int place) {
        const auto& [other, index] = places_[place];
        if (found || other == id || !keep[other]) return;
        const Eigen::Vector3d offset = draft_.links[other].position[index] - link.position[k];
        const double along = offset.dot(direction);
        if (std::abs(along) > radius) return;
        // Across, errors may be large along the weak direction of the sample only.
        const Eigen::Vector3d across = offset - along * direction;
        const double chi_squared = across.dot(link.information[k] * across);
        const bool near = across.norm() <= options_.merge_distance_px * footprint ||
                          (across.norm() <= radius && chi_squared < 9);
        found = near && std::abs(TangentAt(draft_.links[other], index).dot(direction)) > min_cosine;
      });
      covered += found;
    }
    return covered >= kCoveredShare * link.size();
  }

  const DrawingOptions& options_;
  const Draft& draft_;
  VertexGrid grid_;
  std::vector<std::pair<int, int>> places_;
};

// Returns the number of the sketch's samples in the links removed.
int64_t Remove(const std::vector<uint8_t>& keep, Draft* draft) {
  int64_t num_samples = 0;
  for (size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) num_samples += draft->NumSketchSamples(draft->links[i]);
  }
  KeepLinks(keep, draft);
  return num_samples;
}

}  // namespace

CleanupCounts CleanUp(const DrawingOptions& options, Draft* draft) {
  CleanupCounts counts;
  counts.forks_cut = CutForks(options, draft);
  counts.dissolved_nodes += NodeCleaner(options, draft).Run();
  counts.samples_covered += Remove(CoverageCheck(options, *draft).NotCovered(), draft);
  for (bool changed = true; changed;) {
    counts.dissolved_nodes += NodeCleaner(options, draft).Run();
    const size_t before = draft->links.size();
    counts.samples_pruned += Remove(LongOrTied(options, *draft), draft);
    changed = draft->links.size() < before;
  }
  return counts;
}

}  // namespace limn
