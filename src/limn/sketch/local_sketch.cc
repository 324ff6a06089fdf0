#include "limn/sketch/local_sketch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "limn/sketch/sketch_pieces.h"

namespace limn {
namespace {

constexpr double kNarrowSupportDeg = 15;
constexpr double kWideViewsDeg = 30;
// Views sketched between two changes of which edgels are held.
constexpr size_t kBlock = 64;

std::vector<EdgelFate> FatesOutsideFragments(const EdgeMap& edge_map) {
  std::vector<EdgelFate> fates(edge_map.edgels.size(), EdgelFate::kNotLinked);
  for (const EdgelId id : edge_map.texture) fates[id] = EdgelFate::kTexture;
  return fates;
}

class ViewSketcher {
 public:
  ViewSketcher(const PrimaryView& primary, DepthFinder depths)
      : primary_(primary),
        depths_(std::move(depths)),
        support_views_(PartnersIn(primary.plan)),
        fates_(FatesOutsideFragments(Curves().edge_map)) {}

  void Reconstruct(int fragment_id) {
    const SketchOptions& options = primary_.options;
    const FragmentRays fragment = MakeFragmentRays(View(), Curves(), fragment_id);
    if (fragment.size() < 2 || fragment.arc_px.back() < options.min_fragment_length_px) {
      for (size_t i = 0; i < fragment.size(); ++i)
        Fate(fragment_id, i) = EdgelFate::kFragmentTooShort;
      return;
    }
    const std::vector<int> vertices = SpacedVertices(fragment, depths_.spacing_px);
    const DepthProfile profile = depths_.find(Subset(fragment, vertices));
    for (size_t i = 0; i < vertices.size(); ++i) {
      const EdgelFate fate =
          profile.depths[i].has_depth ? EdgelFate::kPieceTooShort : profile.fates[i];
      const size_t next = i + 1 < vertices.size() ? vertices[i + 1] : fragment.size();
      for (size_t k = vertices[i]; k < next; ++k) Fate(fragment_id, k) = fate;
    }
    std::vector<FusedDepth> depths = ExpandDepths(fragment, vertices, profile.depths);
    InterpolateGaps(fragment, &depths);
    for (const VertexRun& run : FindRuns(fragment, depths)) {
      for (int k = 0; k < run.size; ++k) {
        Fate(fragment_id, (run.begin + k) % fragment.size()) = EdgelFate::kSketched;
      }
      Curve3D curve = MakeCurve(View(), fragment, depths, run);
      curve.anchor.view = primary_.id;
      curve.anchor.fragment = fragment_id;
      CollectSupport(primary_.input.scene.views, primary_.input.scene.curves, primary_.edgels.views,
                     support_views_, options.Gate(), &curve);
      curves_.push_back(std::move(curve));
    }
  }

  ViewSketch Take() { return {std::move(curves_), std::move(fates_)}; }

 private:
  const limn::View& View() const { return primary_.input.scene.views[primary_.id]; }
  const ImageCurves& Curves() const { return primary_.input.scene.curves[primary_.id]; }
  EdgelFate& Fate(int fragment, size_t vertex) {
    return fates_[Curves().fragments[fragment].edgel_ids[vertex]];
  }

  const PrimaryView& primary_;
  DepthFinder depths_;
  std::vector<ViewId> support_views_;
  std::vector<Curve3D> curves_;
  std::vector<EdgelFate> fates_;
};

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

// A pure function of what ViewSketchStore lists.
ViewSketch SketchOneView(const PrimaryView& primary, DepthFinder depths,
                         const RunContext& context) {
  ViewSketcher sketcher(primary, std::move(depths));
  const size_t num_fragments = primary.input.scene.curves[primary.id].fragments.size();
  for (size_t f = 0; f < num_fragments; ++f) {
    ThrowIfCancelled(context);
    sketcher.Reconstruct(static_cast<int>(f));
  }
  return sketcher.Take();
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

SketchResult SketchFragments(const char* stage, const SketchInput& input,
                             const SketchOptions& options, const RunContext& context,
                             const ViewSketchStore* store,
                             const std::function<DepthFinder(const PrimaryView&)>& make_finder) {
  options.Check();
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
      by_view[v] = SketchOneView(primary, make_finder(primary), context);
      if (store) store->save(v, plans[v], *by_view[v]);
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
