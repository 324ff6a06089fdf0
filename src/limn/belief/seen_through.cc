// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/seen_through.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <utility>

namespace limn {
namespace {

// Images of links cross where samples come this near and directions differ by more than 37 degrees.
constexpr double kCrossingPx = 1.2;
constexpr double kMaxCosine = 0.8;
// Links are one behind the other if they are this far apart along the line of sight, footprints.
constexpr double kMinBehindPx = 60;
// The farther link must be shown along this share of the samples on either side, and the nearer one
// along no more than that share of the samples next to the crossing, where edges are blurred.
constexpr int kFarBegin = 1, kFarEnd = 7;
constexpr double kFarShownShare = 0.75;
constexpr int kNearBegin = 2, kNearEnd = 6;
constexpr double kNearShownShare = 0.25;
constexpr int kMinSamples = 2;

enum class Shown : uint8_t { kOutside, kNo, kYes, kOwn };

// A link in the image of a view.
struct Trace {
  int link = -1;
  std::vector<std::optional<CurveSight>> sights;  // per sample
  std::vector<Shown> shown;
};

// A sample of a trace, in the cell of the image that it is in.
struct Place {
  int row = 0, col = 0;
  int trace = -1, sample = -1;

  auto operator<=>(const Place&) const = default;
};

Trace MakeTrace(const TopologyInput& input, int link, const ImageEvidence& evidence,
                const LinkSight& sight) {
  Trace trace;
  trace.link = link;
  for (const EvidenceSample& sample : evidence.samples) {
    trace.sights.push_back(See(input.views[sight.view], sample.position, sample.tangent));
    trace.shown.push_back(trace.sights.back() ? Shown::kNo : Shown::kOutside);
  }
  for (const SampleHit& hit : sight.hits) {
    trace.shown[hit.sample] = hit.own ? Shown::kOwn : Shown::kYes;
  }
  return trace;
}

// Share of the samples from `begin` to `end` steps away that are shown; nothing if too few are in
// the image.
template <typename IsShown>
std::optional<double> ShareShown(const Trace& trace, int sample, int begin, int end, int direction,
                                 IsShown&& is_shown) {
  int num = 0;
  int num_shown = 0;
  for (int step = begin; step < end; ++step) {
    const int k = sample + direction * step;
    if (k < 0 || k >= static_cast<int>(trace.shown.size())) break;
    if (trace.shown[k] == Shown::kOutside) continue;
    ++num;
    num_shown += is_shown(trace.shown[k]);
  }
  if (num < kMinSamples) return std::nullopt;
  return static_cast<double>(num_shown) / num;
}

bool ContinuesOnBothSides(const Trace& trace, int sample) {
  return std::ranges::all_of(std::array{1, -1}, [&](int direction) {
    const auto share = ShareShown(trace, sample, kFarBegin, kFarEnd, direction,
                                  [](Shown shown) { return shown == Shown::kOwn; });
    return share && *share >= kFarShownShare;
  });
}

// Known to be shown on neither side.
bool IsMissing(const Trace& trace, int sample) {
  bool known = false;
  for (const int direction : {1, -1}) {
    const auto share = ShareShown(trace, sample, kNearBegin, kNearEnd, direction,
                                  [](Shown shown) { return shown >= Shown::kYes; });
    if (share && *share > kNearShownShare) return false;
    known = known || share;
  }
  return known;
}

// The links of one view.
class Crossings {
 public:
  Crossings(const TopologyInput& input, const std::vector<ImageEvidence>& links,
            double min_evidence, ViewId view)
      : links_(links), min_evidence_(min_evidence), eye_(input.views[view].CenterInWorld()) {
    for (size_t l = 0; l < links.size(); ++l) {
      const auto sight = std::ranges::lower_bound(links[l].sights, view, {}, &LinkSight::view);
      if (sight == links[l].sights.end() || sight->view != view) continue;
      traces_.push_back(MakeTrace(input, static_cast<int>(l), links[l], *sight));
    }
    for (size_t t = 0; t < traces_.size(); ++t) {
      for (size_t k = 0; k < traces_[t].sights.size(); ++k) {
        if (!traces_[t].sights[k]) continue;
        const auto [row, col] = CellOf(traces_[t].sights[k]->position_px);
        places_.push_back({row, col, static_cast<int>(t), static_cast<int>(k)});
      }
    }
    std::ranges::sort(places_);
  }

  // The links through which the view sees others, ascending.
  std::vector<int> SeenThrough() const {
    std::vector<int> found;
    for (size_t t = 0; t < traces_.size(); ++t) {
      const int size = static_cast<int>(traces_[t].sights.size());
      for (int k = 0; k < size; ++k) {
        if (!traces_[t].sights[k] || !IsSeenThrough(static_cast<int>(t), k)) continue;
        found.push_back(traces_[t].link);
        break;
      }
    }
    return found;
  }

 private:
  static std::pair<int, int> CellOf(const Eigen::Vector2d& pixel) {
    return {static_cast<int>(std::floor(pixel.y() / kCrossingPx)),
            static_cast<int>(std::floor(pixel.x() / kCrossingPx))};
  }

  bool IsSeenThrough(int trace, int sample) const {
    const auto [row, col] = CellOf(traces_[trace].sights[sample]->position_px);
    for (int r = row - 1; r <= row + 1; ++r) {
      auto place = std::ranges::lower_bound(places_, Place{r, col - 1, -1, -1});
      for (; place != places_.end() && place->row == r && place->col <= col + 1; ++place) {
        if (place->trace != trace && Contradicts(trace, sample, *place)) return true;
      }
    }
    return false;
  }

  bool Contradicts(int trace, int sample, const Place& other) const {
    const Trace& near = traces_[trace];
    const Trace& far = traces_[other.trace];
    if (links_[far.link].evidence < min_evidence_) return false;
    const CurveSight& here = *near.sights[sample];
    const CurveSight& there = *far.sights[other.sample];
    return (here.position_px - there.position_px).norm() <= kCrossingPx &&
           std::abs(here.direction.dot(there.direction)) <= kMaxCosine &&
           Distance(far, other.sample) - Distance(near, sample) >
               kMinBehindPx * links_[near.link].footprint &&
           ContinuesOnBothSides(far, other.sample) && IsMissing(near, sample);
  }

  double Distance(const Trace& trace, int sample) const {
    return (links_[trace.link].samples[sample].position - eye_).norm();
  }

  const std::vector<ImageEvidence>& links_;
  double min_evidence_;
  Eigen::Vector3d eye_;
  std::vector<Trace> traces_;
  std::vector<Place> places_;  // ascending
};

}  // namespace

std::vector<int> CountViewsThrough(const TopologyInput& input,
                                   const std::vector<ImageEvidence>& links, double min_evidence,
                                   const RunContext& context) {
  std::vector<std::vector<int>> seen_through(input.views.size());
  ParallelFor(context, "crossing links", input.views.size(), [&](size_t v) {
    seen_through[v] = Crossings(input, links, min_evidence, static_cast<ViewId>(v)).SeenThrough();
  });
  std::vector<int> num_views(links.size(), 0);
  for (const std::vector<int>& of_view : seen_through) {
    for (const int l : of_view) ++num_views[l];
  }
  return num_views;
}

}  // namespace limn
