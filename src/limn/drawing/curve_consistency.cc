#include "limn/drawing/curve_consistency.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "limn/util/union_find.h"

namespace limn {
namespace {

// Share of the arc length that belongs to sample k: half the way to its neighbors.
double OwnLength(const std::vector<double>& arc, size_t k) {
  const size_t last = arc.size() - 1;
  return 0.5 * (arc[std::min(k + 1, last)] - arc[k > 0 ? k - 1 : 0]);
}

struct RawOverlap {
  std::vector<int> partner;
  double strong_length_px = 0;
  int strong_links = 0;
};

// Whether the strong links of one curve to another one link the two.
bool IsLinked(const RawOverlap& overlap, const DrawingOptions& options) {
  return options.IsPaper() ? overlap.strong_links >= options.min_strong_links
                           : overlap.strong_length_px >= options.min_linked_length_px;
}

// By the other curve, regularized.
std::map<int, RawOverlap> RawOverlaps(const SampleSet& samples,
                                      const std::vector<SampleLink>& links, int curve,
                                      const DrawingOptions& options) {
  const std::vector<double> arc = ArcPx(samples, curve);
  std::map<int, RawOverlap> overlaps;
  for (const SampleLink& link : links) {
    const size_t k = samples.NameOf(link.sample).sample;
    RawOverlap& overlap = overlaps[samples.curve_of[link.other]];
    overlap.partner.resize(arc.size(), -1);
    overlap.partner[k] = link.other;
    overlap.strong_links += link.num_strong;
    if (link.votes >= options.strong_link_views) overlap.strong_length_px += OwnLength(arc, k);
  }
  for (auto& [other, overlap] : overlaps) {
    RegularizeOverlap(arc, options.overlap_regularity_px, &overlap.partner);
  }
  return overlaps;
}

}  // namespace

void RegularizeOverlap(const std::vector<double>& arc, double regularity_px,
                       std::vector<int>* partner) {
  std::vector<int>& at = *partner;
  const int count = static_cast<int>(at.size());
  const auto has_partner = [&](int k) { return at[k] >= 0; };
  ForEachRun(count, std::not_fn(has_partner), [&](int begin, int end) {
    if (begin == 0 || end == count || arc[end] - arc[begin - 1] > regularity_px) return;
    for (int k = begin; k < end; ++k) {
      const double t = static_cast<double>(k - begin + 1) / (end - begin + 1);
      at[k] = static_cast<int>(std::lround((1 - t) * at[begin - 1] + t * at[end]));
    }
  });
  const double needed = std::min(regularity_px, 0.5 * arc.back());
  ForEachRun(count, has_partner, [&](int begin, int end) {
    if (arc[end - 1] - arc[begin] >= needed) return;
    std::fill(at.begin() + begin, at.begin() + end, -1);
  });
}

CurveConsistency BuildCurveConsistency(const SampleSet& samples, const LocalConsistency& network,
                                       const DrawingOptions& options, const RunContext& context) {
  const int num_curves = samples.NumCurves();
  std::vector<std::map<int, RawOverlap>> raw(num_curves);
  ParallelFor(context, "curve consistency", num_curves, [&](size_t c) {
    raw[c] = RawOverlaps(samples, network[c], static_cast<int>(c), options);
  });
  CurveConsistency result;
  result.overlaps.resize(num_curves);
  result.num_clusters = num_curves;
  UnionFind components(num_curves);
  for (int c = 0; c < num_curves; ++c) {
    for (auto& [other, overlap] : raw[c]) {
      const auto reverse = raw[other].find(c);
      if (!IsLinked(overlap, options) &&
          (reverse == raw[other].end() || !IsLinked(reverse->second, options))) {
        continue;
      }
      // In the paper strong links alone make a cluster.
      const bool overlaps = std::ranges::max(overlap.partner) >= 0;
      if (overlaps || options.IsPaper()) result.num_clusters -= components.Union(c, other);
      if (!overlaps) continue;
      result.overlaps[c].push_back({other, std::move(overlap.partner)});
    }
  }
  for (int c = 0; c < num_curves; ++c) result.cluster_of.push_back(components.Find(c));
  return result;
}

int CountAgreeingViews(const SampleSet& samples, const CurveConsistency& network, int s) {
  const auto [curve, k] = samples.NameOf(s);
  std::set<ViewId> views = {samples.origins[curve].primary_view};
  for (const CurveOverlap& overlap : network.overlaps[curve]) {
    if (overlap.partner[k] >= 0) views.insert(samples.origins[overlap.other].primary_view);
  }
  return static_cast<int>(views.size());
}

}  // namespace limn
