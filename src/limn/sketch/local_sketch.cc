// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/local_sketch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "limn/sketch/sketch_of_depths.h"
#include "limn/sketch/sketch_pieces.h"

namespace limn {
namespace {

constexpr double kNarrowSupportDeg = 15;
constexpr double kWideViewsDeg = 30;
// Views sketched between two changes of which edgels are held.
constexpr size_t kBlock = 64;

std::vector<EdgelFate> FatesOfUnsketched(const ImageCurves& curves) {
  std::vector<EdgelFate> fates = FatesOutsideFragments(curves.edge_map);
  for (const CurveFragment& fragment : curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) fates[id] = EdgelFate::kNotSketched;
  }
  return fates;
}

StageSummary Summarize(const char* stage, const SketchResult& result,
                       const std::vector<ImageCurves>& curves, const std::vector<ViewId>& ids) {
  std::array<int64_t, kNumEdgelFates> counts{};
  int64_t total = 0;
  for (const auto& of_view : result.fates) {
    for (const EdgelFate fate : of_view) ++counts[static_cast<int>(fate)];
  }
  const auto count = [&](EdgelFate fate) { return counts[static_cast<int>(fate)]; };
  for (const int64_t n : counts) total += n;
  int64_t num_fragments = 0;
  for (const ViewId v : ids) {
    num_fragments += static_cast<int64_t>(curves[v].fragments.size());
  }
  StageSummary summary;
  summary.stage = stage;
  summary.in = {{"fragments", num_fragments},
                {"edgels", total - count(EdgelFate::kNotLinked) - count(EdgelFate::kTexture)}};
  summary.kept = {{"edgels", count(EdgelFate::kSketched)},
                  {"curves", static_cast<int64_t>(result.sketch.curves.size())}};
  summary.dropped = {
      {"edgels: view only confirms", count(EdgelFate::kNotSketched)},
      {"edgels: fragment too short", count(EdgelFate::kFragmentTooShort)},
      {"edgels: no partner in another view", count(EdgelFate::kNoPartner)},
      {"edgels: too few supporting views", count(EdgelFate::kTooFewViews)},
      {"edgels: depth inconsistent along the curve", count(EdgelFate::kInconsistent)},
      {"edgels: piece too short", count(EdgelFate::kPieceTooShort)}};
  return summary;
}

// Per view, what the store has; nothing without a store.
std::vector<std::optional<ViewSketch>> LoadSketches(const std::vector<ViewId>& ids,
                                                    const std::vector<ViewPlan>& plans,
                                                    const RunContext& context,
                                                    const ViewSketchStore* store) {
  std::vector<std::optional<ViewSketch>> found(plans.size());
  if (!store) return found;
  ParallelFor(context, "kept sketches", ids.size(),
              [&](size_t i) { found[ids[i]] = store->load(ids[i], plans[ids[i]]); });
  return found;
}

// Of all fragments that are long enough. A pure function of what ViewSketchStore lists.
ViewDepths FindDepths(const PrimaryView& primary, const DepthFinder& finder,
                      const RunContext& context) {
  const ImageCurves& curves = primary.input.scene.curves[primary.id];
  ViewDepths depths;
  depths.spacing_px = finder.spacing_px;
  depths.sample_step = finder.sample_step;
  depths.of_fragment.resize(curves.fragments.size());
  for (size_t f = 0; f < curves.fragments.size(); ++f) {
    ThrowIfCancelled(context);
    const FragmentRays fragment =
        MakeFragmentRays(primary.input.scene.views[primary.id], curves, static_cast<int>(f));
    const bool is_long_enough =
        fragment.size() >= 2 && fragment.arc_px.back() >= primary.options.min_fragment_length_px;
    if (!is_long_enough) continue;
    depths.of_fragment[f] =
        finder.find(Subset(fragment, SpacedVertices(fragment, finder.spacing_px)));
  }
  return depths;
}

ViewSketch WithSupport(const PrimaryView& primary, const ViewDepths& depths) {
  const CurvesScene& scene = primary.input.scene;
  ViewSketch sketch =
      SketchOfDepths(primary.id, scene.views[primary.id], scene.curves[primary.id], depths);
  const std::vector<ViewId> support_views = PartnersIn(primary.plan);
  for (Curve3D& curve : sketch.curves) {
    CollectSupport(scene.views, scene.curves, primary.edgels.indices, support_views,
                   primary.options.Gate(), &curve);
  }
  return sketch;
}

}  // namespace

PrimaryView::PrimaryView(const SketchInput& sketch_input, ViewId view, const ViewPlan& view_plan,
                         const SketchEdgels& sketch_edgels, const SketchOptions& sketch_options)
    : input(sketch_input),
      id(view),
      plan(view_plan),
      edgels(sketch_edgels),
      options(sketch_options),
      confirmation(view, plan.confirmation_views, input.scene.views, edgels.masks),
      world_from_cam(Inverse(input.scene.views[view].cam_from_world)) {}

PrimaryView::Verdict PrimaryView::Judge(const HypothesisSupport& support, size_t j,
                                        const Eigen::Vector3d& point_in_cam) const {
  const int required = options.min_supporting_views;
  const bool certain = support.weighted[j] >= required;
  if (std::popcount(support.supporting[j]) < required) return {};
  if (input.scene.box && !input.scene.box->contains(world_from_cam * point_in_cam)) return {};
  if (options.by_weight_alone) return {certain, certain};
  if (confirmation.MaxAngleDeg(point_in_cam, support.supporting[j]) < kNarrowSupportDeg &&
      confirmation.MaxAngleDeg(point_in_cam, support.contained[j]) > kWideViewsDeg) {
    return {};
  }
  return {true, certain};
}

SketchOptions ForScene(SketchOptions options, const std::vector<View>& views) {
  options.min_supporting_views =
      std::min(options.min_supporting_views, CountOtherPlaces(views, options.min_supporting_views));
  return options;
}

SketchResult SketchFragments(const char* stage, const SketchInput& input,
                             const SketchOptions& given, const RunContext& context,
                             const ViewSketchStore* store,
                             const std::function<DepthFinder(const PrimaryView&)>& make_finder) {
  given.Check();
  const SketchOptions options = ForScene(given, input.scene.views);
  std::vector<ViewPlan> plans = input.plans ? *input.plans
                                            : SelectViews(input.scene.views, input.scene.hints,
                                                          options.view_selection, context);
  const std::vector<ViewId> ids = IdsOf(input.only, input.scene.views.size());
  std::vector<ViewId> primaries;
  for (const ViewId v : ids) {
    if (plans[v].is_primary) primaries.push_back(v);
  }
  if (store) store->expect(primaries.size());
  std::vector<std::optional<ViewSketch>> by_view = LoadSketches(primaries, plans, context, store);
  std::vector<ViewId> missing;
  for (const ViewId v : primaries) {
    if (!by_view[v]) missing.push_back(v);
  }
  SketchEdgels edgels(input.scene.views.size());
  for (size_t begin = 0; begin < missing.size(); begin += kBlock) {
    const std::vector<ViewId> block(missing.begin() + begin,
                                    missing.begin() + std::min(begin + kBlock, missing.size()));
    HoldViews(WithPartners(block, plans), input, options.Gate(), context, &edgels);
    ParallelFor(PartOf(context, begin, missing.size()), stage, block.size(), [&](size_t b) {
      const ViewId v = block[b];
      const PrimaryView primary(input, v, plans[v], edgels, options);
      const ViewDepths depths = FindDepths(primary, make_finder(primary), context);
      by_view[v] = WithSupport(primary, depths);
      if (store) store->save(v, plans[v], depths, by_view[v]->curves);
    });
  }
  SketchResult result;
  result.fates.resize(input.scene.views.size());
  for (const ViewId v : ids) {
    result.fates[v] = FatesOfUnsketched(input.scene.curves[v]);
  }
  for (const ViewId v : primaries) {
    std::move(by_view[v]->curves.begin(), by_view[v]->curves.end(),
              std::back_inserter(result.sketch.curves));
    result.fates[v] = std::move(by_view[v]->fates);
  }
  result.plans = std::move(plans);
  result.summary = Summarize(stage, result, input.scene.curves, ids);
  return result;
}

}  // namespace limn
