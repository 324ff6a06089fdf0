#include "limn/drawing/curve_consistency.h"

#include <algorithm>
#include <cmath>
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
};

std::map<int, RawOverlap> RawOverlaps(const SampleSet& samples, const LocalConsistency& network,
                                      const DrawingOptions& options, int curve,
                                      const std::vector<double>& arc) {
  std::map<int, RawOverlap> overlaps;
  const int begin = samples.curve_begin[curve];
  for (size_t k = 0; k < arc.size(); ++k) {
    const size_t s = begin + k;
    for (size_t l = network.begin[s]; l < network.begin[s + 1]; ++l) {
      const SampleLink& link = network.links[l];
      RawOverlap& overlap = overlaps[samples.curve_of[link.other]];
      if (overlap.partner.empty()) overlap.partner.assign(arc.size(), -1);
      overlap.partner[k] = link.other;
      if (link.votes >= options.strong_link_views) overlap.strong_length_px += OwnLength(arc, k);
    }
  }
  return overlaps;
}

}  // namespace

void RegularizeOverlap(const std::vector<double>& arc, double max_gap, double min_run,
                       std::vector<int>* partner) {
  const int count = static_cast<int>(partner->size());
  int last = -1;
  for (int k = 0; k < count; ++k) {
    if ((*partner)[k] < 0) continue;
    if (last >= 0 && k > last + 1 && arc[k] - arc[last] <= max_gap) {
      for (int i = last + 1; i < k; ++i) {
        const double t = static_cast<double>(i - last) / (k - last);
        (*partner)[i] =
            static_cast<int>(std::lround((1 - t) * (*partner)[last] + t * (*partner)[k]));
      }
    }
    last = k;
  }
  const double needed = std::min(min_run, 0.5 * arc.back());
  int begin = 0;
  for (int k = 0; k <= count; ++k) {
    if (k < count && (*partner)[k] >= 0) continue;
    if (k > begin && arc[k - 1] - arc[begin] < needed) {
      std::fill(partner->begin() + begin, partner->begin() + k, -1);
    }
    begin = k + 1;
  }
}

CurveConsistency BuildCurveConsistency(const SampleSet& samples, const LocalConsistency& network,
                                       const DrawingOptions& options, const RunContext& context) {
  const int num_curves = samples.NumCurves();
  std::vector<std::map<int, RawOverlap>> raw(num_curves);
  std::vector<std::vector<double>> arcs(num_curves);
  ParallelFor(context, "curve consistency", num_curves, [&](size_t c) {
    arcs[c] = ArcPx(samples, static_cast<int>(c));
    raw[c] = RawOverlaps(samples, network, options, static_cast<int>(c), arcs[c]);
  });
  CurveConsistency result;
  result.overlaps.resize(num_curves);
  UnionFind components(num_curves);
  for (int c = 0; c < num_curves; ++c) {
    for (auto& [other, overlap] : raw[c]) {
      const auto reverse = raw[other].find(c);
      const double reverse_length =
          reverse != raw[other].end() ? reverse->second.strong_length_px : 0;
      if (std::max(overlap.strong_length_px, reverse_length) < options.min_linked_length_px) {
        continue;
      }
      RegularizeOverlap(arcs[c], options.overlap_regularity_px, options.overlap_regularity_px,
                        &overlap.partner);
      if (std::all_of(overlap.partner.begin(), overlap.partner.end(),
                      [](int p) { return p < 0; })) {
        continue;
      }
      components.Union(c, other);
      result.overlaps[c].push_back({other, std::move(overlap.partner)});
    }
  }
  for (int c = 0; c < num_curves; ++c) result.cluster.push_back(components.Find(c));
  return result;
}

std::vector<int> CountAgreeingViews(const SampleSet& samples, const CurveConsistency& network) {
  std::vector<int> counts(samples.NumSamples(), 0);
  for (int c = 0; c < samples.NumCurves(); ++c) {
    std::vector<std::set<ViewId>> views(samples.Size(c));
    for (auto& of_sample : views) of_sample.insert(samples.origins[c].anchor_view);
    for (const CurveOverlap& overlap : network.overlaps[c]) {
      for (size_t k = 0; k < views.size(); ++k) {
        if (overlap.partner[k] >= 0) views[k].insert(samples.origins[overlap.other].anchor_view);
      }
    }
    for (size_t k = 0; k < views.size(); ++k) {
      counts[samples.curve_begin[c] + k] = static_cast<int>(views[k].size());
    }
  }
  return counts;
}

}  // namespace limn
