#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "limn/drawing/junctions.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
// A gap this small needs no evidence of its own.
constexpr double kSmallGapPx = 3;

class ContinuationJoiner {
 public:
  ContinuationJoiner(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                     JunctionCounts* counts)
      : options_(options), ends_(ends), draft_(draft), counts_(counts) {}

  void Run() {
    const auto ends = ends_.Free();
    const auto lines = ends_.Lines(ends);
    std::vector<std::tuple<double, int, int>> candidates;
    for (const auto& [i, j] : ends_.NearPairs(lines)) {
      const auto gap = ContinuationGap(lines[i], lines[j]);
      if (gap) candidates.push_back({*gap, i, j});
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<bool> used(ends.size(), false);
    // Ends joined in pairs; links are concatenated afterwards, along the chains of pairs.
    std::map<std::pair<int, int>, LinkEnd> next;
    for (const auto& [gap, i, j] : candidates) {
      if (used[i] || used[j]) continue;
      const Eigen::Vector3d middle = 0.5 * (lines[i].point + lines[j].point);
      if (gap > kSmallGapPx && !ends_.ImagesAgree(middle, ends_.FragmentsAtEnd(ends[i]),
                                                  ends_.FragmentsAtEnd(ends[j]))) {
        ++counts_->without_image_evidence;
        continue;
      }
      used[i] = used[j] = true;
      next[{ends[i].link, ends[i].end}] = ends[j];
      next[{ends[j].link, ends[j].end}] = ends[i];
      ++counts_->continued;
    }
    Concatenate(next);
  }

 private:
  // Cost of joining two ends into one link: the gap, px; nothing if they do not continue each
  // other.
  std::optional<double> ContinuationGap(const EndLine& a, const EndLine& b) const {
    if (a.outward.dot(b.outward) > -std::cos(options_.max_continuation_angle_deg * kDeg)) {
      return std::nullopt;
    }
    const Eigen::Vector3d offset = b.point - a.point;
    const double along_a = offset.dot(a.outward);
    const double along_b = -offset.dot(b.outward);
    if (!ends_.InReach(along_a, a.footprint) || !ends_.InReach(along_b, a.footprint))
      return std::nullopt;
    const double miss = std::max((offset - along_a * a.outward).norm(),
                                 (offset - offset.dot(b.outward) * b.outward).norm());
    if (miss > options_.max_junction_miss_px * a.footprint) return std::nullopt;
    return offset.norm() / a.footprint;
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

  void Concatenate(const std::map<std::pair<int, int>, LinkEnd>& next) {
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
        link.grown = part.grown && (link.size() == 0 || link.grown);
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

  const DrawingOptions& options_;
  LinkEnds& ends_;
  Draft* draft_;
  JunctionCounts* counts_;
};

}  // namespace

void JoinContinuations(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                       JunctionCounts* counts) {
  ContinuationJoiner(options, ends, draft, counts).Run();
}

}  // namespace limn
