#include "limn/pipeline/sketch_views.h"

#include <string>
#include <vector>

#include "limn/formats/view_sketch_file.h"
#include "limn/pipeline/content_hash.h"
#include "limn/pipeline/curves_key.h"
#include "limn/pipeline/pipeline_options.h"

namespace limn {
namespace {

// What the sketches of all views depend on.
std::string CommonKey(SketchMode mode, const SketchInput& input, const SketchOptions& options) {
  return std::string(SketchModeName(mode)) + " sketch, version " + std::to_string(kSketchVersion) +
         "\n" + OptionsAsText(options.view_selection) + OptionsAsText(options) + "box " +
         BoxKey(input.box) + "\nview ";
}

// Sketches hold ids of views, so these count too.
std::string PlanKey(ViewId view, const ViewPlan& plan, const std::vector<std::string>& view_keys) {
  ContentHash hash;
  const auto add_view = [&](ViewId id) {
    hash.AddNumber(id);
    hash.AddText(view_keys[id]);
  };
  hash.AddNumber(view_keys.size());
  add_view(view);
  hash.AddNumber(plan.min_depth);
  hash.AddNumber(plan.max_depth);
  for (const std::vector<ViewId>* others : {&plan.second_views, &plan.confirmation_views}) {
    hash.AddNumber(others->size());
    for (const ViewId id : *others) add_view(id);
  }
  return hash.Hex();
}

}  // namespace

SketchResult SketchViews(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         ResultCache* cache, const RunContext& context, const std::string& part) {
  if (!cache->IsOn() || mode == SketchMode::kOriginal) {
    return BuildSketch(mode, input, options, context);
  }
  const std::string common_key = CommonKey(mode, input, options);
  const std::vector<std::string> view_keys = ViewKeys(input.views, input.curves, context);
  const auto key = [&](ViewId v, const ViewPlan& plan) {
    return common_key + PlanKey(v, plan, view_keys);
  };
  const auto name = [&](ViewId v) {
    return part.empty() ? input.views[v].name : part + "/" + input.views[v].name;
  };
  ViewSketchStore store;
  store.expect = [&](size_t num_views) { cache->Expect(CachedKind::kSketch, num_views); };
  store.load = [&](ViewId v, const ViewPlan& plan) {
    return cache->Find<ViewSketch>(CachedKind::kSketch, name(v), [&](const std::string& path) {
      return ReadViewSketch(path, v, input.curves, key(v, plan));
    });
  };
  store.save = [&](ViewId v, const ViewPlan& plan, const ViewSketch& sketch) {
    cache->Store(CachedKind::kSketch, name(v),
                 [&](const std::string& path) { WriteViewSketch(path, sketch, key(v, plan)); });
  };
  return BuildSketch(mode, input, options, context, &store);
}

}  // namespace limn
