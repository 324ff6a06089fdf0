#include "limn/drawing/local_consistency.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/map_items.h"

namespace limn {
namespace {

// Edgels of one view farther apart than this across the edge belong to different edges, px.
constexpr double kSideBySidePx = 1;

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

// Views in which the two samples are supported by different edgels that lie side by side.
int CountSideBySide(const SampleSet& samples, const std::vector<ImageCurves>& curves, int a,
                    int b) {
  int count = 0;
  const auto support_b = samples.support.Of(b);
  for (const EdgelRef& ref : samples.support.Of(a)) {
    const auto found = std::ranges::lower_bound(support_b, ref.view, {}, &EdgelRef::view);
    if (found == support_b.end() || found->view != ref.view) continue;
    const std::vector<Edgel>& edgels = curves[ref.view].edge_map.edgels;
    const Edgel& edgel = edgels[ref.edgel];
    const Eigen::Vector2d offset = edgel.stored_from_virtual.cast<double>() *
                                   (edgels[found->edgel].position_px - edgel.position_px);
    count += std::abs(edgel.Normal().dot(offset)) > kSideBySidePx;
  }
  return count;
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

std::vector<SampleLink> LinksOf(const SampleSet& samples, const std::vector<ImageCurves>& curves,
                                const EdgelClaims& claims, const DrawingOptions& options, int s) {
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
    if (!options.IsPaper() && LineAngleBetween(samples.tangent[s], samples.tangent[link.other]) >
                                  options.max_link_angle_deg * kDeg) {
      continue;
    }
    if (best.empty() || samples.curve_of[best.back().other] != samples.curve_of[link.other]) {
      best.push_back(link);
    } else if (rank(link) < rank(best.back())) {
      link.num_strong = best.back().num_strong;
      best.back() = link;
    }
    best.back().num_strong += link.votes >= options.strong_link_views;
  }
  if (options.IsPaper()) return best;
  std::erase_if(best, [&](const SampleLink& link) {
    return CountSideBySide(samples, curves, s, link.other) >= link.votes;
  });
  return best;
}

}  // namespace

LocalConsistency BuildLocalConsistency(const SampleSet& samples,
                                       const std::vector<ImageCurves>& curves,
                                       const DrawingOptions& options, const RunContext& context) {
  const EdgelClaims claims = CollectClaims(samples, curves.size());
  return MapItems(context, "local consistency", samples.NumCurves(), [&](size_t c) {
    std::vector<SampleLink> of_curve;
    for (int s = samples.curve_begin[c]; s < samples.curve_begin[c + 1]; ++s) {
      const std::vector<SampleLink> of_sample = LinksOf(samples, curves, claims, options, s);
      of_curve.insert(of_curve.end(), of_sample.begin(), of_sample.end());
    }
    return of_curve;
  });
}

}  // namespace limn
