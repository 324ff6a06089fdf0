// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/link_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr int kNumClasses = 4;
// A link is behind the surface if most of its supporting views' judgments of its samples say so,
// and if they can judge enough of the samples: the others may be anywhere.
constexpr double kMaxOccludedShare = 0.5;
constexpr double kMinJudgedShare = 0.3;

DenseClass ClassOfSample(const SampleSupport& support) {
  const int num_judged = support.num_surface + support.num_boundary + support.num_free;
  const bool known = num_judged > 0 || !support.visible_in.empty();
  if (support.num_touching == 0) return known ? DenseClass::kFree : DenseClass::kUnknown;
  if (num_judged == 0) return DenseClass::kUnknown;
  if (support.num_surface >= support.num_boundary && support.num_surface >= support.num_free) {
    return DenseClass::kSurface;
  }
  return support.num_boundary >= support.num_free ? DenseClass::kBoundary : DenseClass::kFree;
}

// Sums over the samples of one link.
struct LinkSums {
  std::array<double, kNumClasses> length = {};
  double whole_length = 0;
  double added = 0;
  double judged = 0;  // what supporting views can say, in views times length
  double occluded = 0;
  double asked = 0;
  double fold_rad = 0;
  double fold_length = 0;
};

int CountCommon(const std::vector<ViewId>& a, const std::vector<ViewId>& b) {
  return static_cast<int>(std::count_if(a.begin(), a.end(), [&](ViewId view) {
    return std::binary_search(b.begin(), b.end(), view);
  }));
}

void Add(const SampleSupport& support, double length, DenseClass sample_class,
         const std::vector<ViewId>& supporting, LinkSums* sums) {
  sums->length[static_cast<int>(sample_class)] += length;
  sums->whole_length += length;
  const int visible = CountCommon(support.visible_in, supporting);
  const int occluded = CountCommon(support.occluded_in, supporting);
  sums->judged += length * (visible + occluded);
  sums->occluded += length * occluded;
  sums->asked += length * static_cast<double>(supporting.size());
  const auto& [left, right] = support.normal;
  if (sample_class == DenseClass::kSurface && left.norm() > 0 && right.norm() > 0) {
    sums->fold_rad += length * std::acos(std::clamp(left.dot(right), -1.0, 1.0));
    sums->fold_length += length;
  }
}

LinkDense Judge(const LinkSums& sums, const DenseOptions& options) {
  LinkDense result;
  if (!(sums.whole_length > 0)) return result;
  const auto most = std::max_element(sums.length.begin(), sums.length.end());
  result.dense_class = static_cast<DenseClass>(most - sums.length.begin());
  result.added_share = sums.added / sums.whole_length;
  if (sums.judged > 0) result.occluded_share = sums.occluded / sums.judged;
  const double visible_views = (sums.judged - sums.occluded) / sums.whole_length;
  result.behind_surface = sums.judged >= kMinJudgedShare * sums.asked &&
                          result.occluded_share > kMaxOccludedShare &&
                          visible_views < options.enough_visible_views;
  if (sums.fold_length > 0) result.fold_deg = Degrees(sums.fold_rad / sums.fold_length);
  return result;
}

template <typename Counts>
double SumLengths(const DrawingSamples& samples, const DenseClasses& classes, bool behind,
                  const Counts& counts) {
  double length = 0;
  for (size_t s = 0; s < samples.size(); ++s) {
    if (classes.links[samples.link[s]].behind_surface == behind && counts(s)) {
      length += samples.length[s];
    }
  }
  return length;
}

}  // namespace

DenseClasses ClassifyLinks(const DrawingGraph& graph, const DrawingSamples& samples,
                           const std::vector<SampleSupport>& support,
                           std::vector<uint8_t> near_dense, const DenseOptions& options) {
  DenseClasses classes;
  std::vector<LinkSums> sums(graph.links.size());
  for (size_t s = 0; s < samples.size(); ++s) {
    const DenseClass of_sample = ClassOfSample(support[s]);
    classes.sample_class.push_back(of_sample);
    LinkSums& of_link = sums[samples.link[s]];
    Add(support[s], samples.length[s], of_sample, graph.links[samples.link[s]].supporting_views,
        &of_link);
    if (near_dense[s] == 0) of_link.added += samples.length[s];
  }
  classes.near_dense = std::move(near_dense);
  for (const LinkSums& of_link : sums) classes.links.push_back(Judge(of_link, options));
  return classes;
}

double LengthBehind(const DrawingSamples& samples, const DenseClasses& classes) {
  return SumLengths(samples, classes, true, [](size_t) { return true; });
}

double LengthOf(DenseClass wanted, const DrawingSamples& samples, const DenseClasses& classes) {
  return SumLengths(samples, classes, false,
                    [&](size_t s) { return classes.sample_class[s] == wanted; });
}

double LengthAdded(const DrawingSamples& samples, const DenseClasses& classes) {
  return SumLengths(samples, classes, false, [&](size_t s) { return classes.near_dense[s] == 0; });
}

}  // namespace limn
