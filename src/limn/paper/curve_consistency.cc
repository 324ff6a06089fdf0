// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/curve_consistency.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "limn/util/runs.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

struct RawOverlap {
  std::vector<int> partner;
  int strong_links = 0;
};

// By the other curve, regularized.
std::map<int, RawOverlap> RawOverlaps(const SampleSet& samples,
                                      const std::vector<SampleLink>& links, int curve,
                                      const PaperOptions& options) {
  const std::vector<double> arc = ArcPx(samples, curve);
  std::map<int, RawOverlap> overlaps;
  for (const SampleLink& link : links) {
    RawOverlap& overlap = overlaps[samples.curve_of[link.other]];
    overlap.partner.resize(arc.size(), -1);
    overlap.partner[samples.NameOf(link.sample).sample] = link.other;
    overlap.strong_links += link.num_strong;
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
                                       const PaperOptions& options, const RunContext& context) {
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
      const int back = reverse == raw[other].end() ? 0 : reverse->second.strong_links;
      if (std::max(overlap.strong_links, back) < options.min_strong_links) continue;
      // Strong links alone make a cluster.
      result.num_clusters -= components.Union(c, other);
      if (std::ranges::max(overlap.partner) < 0) continue;
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
