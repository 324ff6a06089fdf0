// SPDX-License-Identifier: BSD-3-Clause
#include "limn/dense/fuse_drawing.h"

#include <algorithm>

#include "limn/dense/kind_on_surface.h"
#include "limn/dense/point_distance.h"

namespace limn {
namespace {

std::vector<uint8_t> NearDense(const FusionInput& input, const DrawingSamples& samples,
                               const std::vector<SampleSupport>& support,
                               const DenseOptions& options) {
  if (input.cloud) return FindSamplesNearPoints(samples, *input.cloud, options.near_px);
  std::vector<uint8_t> near;
  for (const SampleSupport& of_sample : support) near.push_back(of_sample.num_touching > 0);
  return near;
}

StageSummary Summary(const DenseClasses& classes, size_t num_samples) {
  const auto count = [&](const auto& is) {
    return static_cast<int64_t>(std::count_if(classes.links.begin(), classes.links.end(), is));
  };
  const auto of_class = [&](DenseClass wanted) {
    return count(
        [=](const LinkDense& link) { return !link.behind_surface && link.dense_class == wanted; });
  };
  StageSummary summary;
  summary.stage = "fusion";
  summary.in = {{"links", static_cast<int64_t>(classes.links.size())},
                {"samples", static_cast<int64_t>(num_samples)}};
  summary.kept = {{"links on a surface", of_class(DenseClass::kSurface)},
                  {"links at a boundary", of_class(DenseClass::kBoundary)},
                  {"links off the surface", of_class(DenseClass::kFree)},
                  {"links that no view can judge", of_class(DenseClass::kUnknown)}};
  summary.dropped = {
      {"links behind the surface", count([](const LinkDense& l) { return l.behind_surface; })}};
  return summary;
}

}  // namespace

FusionResult FuseDrawing(const FusionInput& input, const DenseOptions& options,
                         const RunContext& context) {
  options.Check();
  FusionResult result;
  result.graph = input.graph;
  result.samples = SampleDrawing(input.graph, input.views, options.sample_spacing_px);
  const SurelySeen seen(input.graph, result.samples, input.views);
  DepthWatch watch(seen, input.views, input.depths_are_separate, options);
  std::vector<SampleSupport> support =
      FindSampleSupport(result.samples, input.views, watch.Watched(input.depths), options, context);
  result.trust = watch.Judge();
  if (input.depths_are_separate) {
    ExplainDoubts(seen, input.views, input.depths, options, &result.trust);
  }
  if (!result.trust.is_believed) {
    support.assign(support.size(), {});
  } else if (!result.trust.unfit.empty()) {
    support = FindSampleSupport(result.samples, input.views,
                                Without(result.trust.unfit, input.depths), options, context);
  }
  result.classes = ClassifyLinks(input.graph, result.samples, support,
                                 NearDense(input, result.samples, support, options), options);
  for (size_t l = 0; l < result.graph.links.size(); ++l) {
    result.graph.links[l].dense = result.classes.links[l];
    UseSurfaceForKind(&result.graph.links[l]);
  }
  result.points = MakeCurvePoints(result.graph, result.samples, support, result.classes);
  result.summary = Summary(result.classes, result.samples.size());
  return result;
}

DrawingGraph WithoutOccluded(const DrawingGraph& graph) {
  std::vector<uint8_t> keep;
  for (const DrawingLink& link : graph.links) {
    keep.push_back(!link.dense || !link.dense->behind_surface);
  }
  DrawingGraph kept = graph;
  RemoveLinks(keep, &kept);
  return kept;
}

}  // namespace limn
