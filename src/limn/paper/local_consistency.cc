// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/local_consistency.h"

#include <algorithm>
#include <utility>

#include "limn/util/map_items.h"

namespace limn {
namespace {

// Per view the edgels with the samples that they support, ascending.
using EdgelClaims = std::vector<std::vector<std::pair<EdgelId, int>>>;

EdgelClaims CollectClaims(const SampleSet& samples, size_t num_views) {
  EdgelClaims claims(num_views);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    for (const EdgelRef& ref : samples.support.Of(s)) claims[ref.view].push_back({ref.edgel, s});
  }
  for (auto& of_view : claims) std::ranges::sort(of_view);
  return claims;
}

// The samples of curves of other primary views that a sample shares edgels with: each once per
// edgel, ascending.
std::vector<int> SharingSamples(const SampleSet& samples, const EdgelClaims& claims, int s) {
  std::vector<int> sharing;
  const auto primary = [&](int id) { return samples.origins[samples.curve_of[id]].primary_view; };
  for (const EdgelRef& ref : samples.support.Of(s)) {
    const auto& in_view = claims[ref.view];
    for (auto claim =
             std::ranges::lower_bound(in_view, ref.edgel, {}, &std::pair<EdgelId, int>::first);
         claim != in_view.end() && claim->first == ref.edgel; ++claim) {
      if (primary(claim->second) != primary(s)) sharing.push_back(claim->second);
    }
  }
  std::sort(sharing.begin(), sharing.end());
  return sharing;
}

std::vector<SampleLink> LinksOf(const SampleSet& samples, const EdgelClaims& claims,
                                const PaperOptions& options, int s) {
  // Most votes first, then nearest.
  const auto rank = [&](const SampleLink& link) {
    return std::pair(-link.votes,
                     (samples.position[link.other] - samples.position[s]).squaredNorm());
  };
  std::vector<SampleLink> best;  // per other curve, whose sample ids are consecutive
  const std::vector<int> sharing = SharingSamples(samples, claims, s);
  for (auto next = sharing.begin(); next != sharing.end();) {
    const auto first = next;
    next = std::upper_bound(first, sharing.end(), *first);
    SampleLink link{s, *first, static_cast<int>(next - first)};
    if (link.votes < options.dense_link_views) continue;
    if (best.empty() || samples.curve_of[best.back().other] != samples.curve_of[link.other]) {
      best.push_back(link);
    } else if (rank(link) < rank(best.back())) {
      link.num_strong = best.back().num_strong;
      best.back() = link;
    }
    best.back().num_strong += link.votes >= options.strong_link_views;
  }
  return best;
}

}  // namespace

LocalConsistency BuildLocalConsistency(const SampleSet& samples, size_t num_views,
                                       const PaperOptions& options, const RunContext& context) {
  const EdgelClaims claims = CollectClaims(samples, num_views);
  return MapItems(context, "local consistency", samples.NumCurves(), [&](size_t c) {
    std::vector<SampleLink> of_curve;
    for (int s = samples.curve_begin[c]; s < samples.curve_begin[c + 1]; ++s) {
      const std::vector<SampleLink> of_sample = LinksOf(samples, claims, options, s);
      of_curve.insert(of_curve.end(), of_sample.begin(), of_sample.end());
    }
    return of_curve;
  });
}

}  // namespace limn
