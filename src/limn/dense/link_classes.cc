#include "limn/dense/link_classes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

constexpr int kNumClasses = 4;

DenseClass ClassOfSample(const SampleEvidence& evidence, bool near_dense) {
  const int num_judged = evidence.num_surface + evidence.num_boundary + evidence.num_free;
  const bool known = num_judged > 0 || !evidence.visible_in.empty();
  if (!near_dense)
    return known || evidence.occluded_in.empty() ? DenseClass::kFree : DenseClass::kUnknown;
  if (num_judged == 0) return DenseClass::kUnknown;
  if (evidence.num_surface >= evidence.num_boundary && evidence.num_surface >= evidence.num_free) {
    return DenseClass::kSurface;
  }
  return evidence.num_boundary >= evidence.num_free ? DenseClass::kBoundary : DenseClass::kFree;
}

// Sums over the samples of one link.
struct LinkSums {
  std::array<double, kNumClasses> length = {};
  double whole_length = 0;
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

void Add(const SampleEvidence& evidence, double length, DenseClass sample_class,
         const std::vector<ViewId>& supporting, LinkSums* sums) {
  sums->length[static_cast<int>(sample_class)] += length;
  sums->whole_length += length;
  const int visible = CountCommon(evidence.visible_in, supporting);
  const int occluded = CountCommon(evidence.occluded_in, supporting);
  sums->judged += length * (visible + occluded);
  sums->occluded += length * occluded;
  sums->asked += length * static_cast<double>(supporting.size());
  const auto& [left, right] = evidence.normal;
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
  result.free_share = sums.length[static_cast<int>(DenseClass::kFree)] / sums.whole_length;
  if (sums.judged > 0) result.occluded_share = sums.occluded / sums.judged;
  result.behind_surface = sums.judged >= options.min_judged_share * sums.asked &&
                          result.occluded_share > options.max_occluded_share;
  if (sums.fold_length > 0) result.fold_deg = sums.fold_rad / sums.fold_length * 180 / M_PI;
  return result;
}

}  // namespace

DenseClasses ClassifyLinks(const DrawingGraph& graph, const DrawingSamples& samples,
                           const std::vector<SampleEvidence>& evidence,
                           const std::vector<uint8_t>& near_dense, const DenseOptions& options) {
  DenseClasses classes;
  std::vector<LinkSums> sums(graph.links.size());
  for (size_t s = 0; s < samples.size(); ++s) {
    const DenseClass of_sample = ClassOfSample(evidence[s], near_dense[s] != 0);
    classes.sample_class.push_back(of_sample);
    Add(evidence[s], samples.length[s], of_sample, graph.links[samples.link[s]].supporting_views,
        &sums[samples.link[s]]);
  }
  for (const LinkSums& of_link : sums) classes.links.push_back(Judge(of_link, options));
  return classes;
}

double LengthBehind(const DrawingSamples& samples, const DenseClasses& classes) {
  double length = 0;
  for (size_t s = 0; s < samples.size(); ++s) {
    if (classes.links[samples.link[s]].behind_surface) length += samples.length[s];
  }
  return length;
}

double LengthOf(DenseClass wanted, const DrawingSamples& samples, const DenseClasses& classes) {
  double length = 0;
  for (size_t s = 0; s < samples.size(); ++s) {
    const bool behind = classes.links[samples.link[s]].behind_surface;
    if (!behind && classes.sample_class[s] == wanted) length += samples.length[s];
  }
  return length;
}

}  // namespace limn
