// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/sketch_views.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "limn/cache/content_hash.h"
#include "limn/cache/curves_key.h"
#include "limn/cache/view_sketch_file.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/sketch/local_sketch.h"

namespace limn {
namespace {

// What the sketches of all views depend on.
std::string CommonKey(SketchMode mode, const SketchInput& input, const SketchOptions& options) {
  return std::string(SketchModeName(mode)) + " sketch, version " + std::to_string(kSketchVersion) +
         "\n" + OptionsAsText(options.view_selection) +
         OptionsAsText(ForScene(options, input.scene.views)) + "box " + BoxKey(input.scene.box) +
         "\nview ";
}

std::string PlanKey(const SketchIdentity& identity, ViewId view, const ViewPlan& plan,
                    const std::vector<std::string>& view_keys) {
  ContentHash hash;
  hash.AddNumber(identity.views.size());
  for (const ViewId id : identity.views) hash.AddText(view_keys[id]);
  hash.AddNumber(identity.PlaceOf(view));
  hash.AddNumber(plan.min_depth);
  hash.AddNumber(plan.max_depth);
  for (const std::vector<ViewId>* others : {&plan.second_views, &plan.confirmation_views}) {
    hash.AddNumber(others->size());
    for (const ViewId id : *others) hash.AddNumber(identity.PlaceOf(id));
  }
  return hash.Hex();
}

class SketchStore {
 public:
  SketchStore(SketchMode mode, const SketchInput& input, const SketchOptions& options,
              ResultCache* cache, const RunContext& context, std::string part)
      : mode_(mode),
        input_(input),
        options_(options),
        cache_(*cache),
        part_(std::move(part)),
        view_keys_(ViewKeys(input.scene.views, input.scene.curves, context)) {}

  std::optional<ViewSketch> Load(ViewId view, const ViewPlan& plan) const {
    const SketchIdentity identity = IdentityOf(view, plan);
    return cache_.Find<ViewSketch>(CachedKind::kSketch, NameOf(view), [&](const std::string& path) {
      return ReadViewSketch(path, view, identity.views, input_.scene.views, input_.scene.curves,
                            identity.key);
    });
  }

  void Save(ViewId view, const ViewPlan& plan, const ViewDepths& depths,
            const std::vector<Curve3D>& curves) const {
    const SketchIdentity identity = IdentityOf(view, plan);
    cache_.Store(CachedKind::kSketch, NameOf(view), [&](const OutputPath& path) {
      WriteViewSketch(path, depths, curves, identity.views, input_.scene.curves, identity.key);
    });
  }

 private:
  SketchIdentity IdentityOf(ViewId view, const ViewPlan& plan) const {
    return IdentityOfSketch(mode_, input_, options_, view, plan, view_keys_);
  }
  std::string NameOf(ViewId view) const {
    const std::string& name = input_.scene.views[view].name;
    return part_.empty() ? name : part_ + "/" + name;
  }

  SketchMode mode_;
  const SketchInput& input_;
  const SketchOptions& options_;
  ResultCache& cache_;
  std::string part_;
  std::vector<std::string> view_keys_;
};

}  // namespace

ViewId SketchIdentity::PlaceOf(ViewId view) const {
  return static_cast<ViewId>(std::ranges::lower_bound(views, view) - views.begin());
}

SketchIdentity IdentityOfSketch(SketchMode mode, const SketchInput& input,
                                const SketchOptions& options, ViewId view, const ViewPlan& plan,
                                const std::vector<std::string>& view_keys) {
  SketchIdentity identity = {PartnersIn(plan), ""};
  identity.views.insert(std::ranges::lower_bound(identity.views, view), view);
  identity.key = CommonKey(mode, input, options) + PlanKey(identity, view, plan, view_keys);
  return identity;
}

std::vector<ViewId> PlacesIn(const std::vector<ViewId>& views, size_t num_views) {
  std::vector<ViewId> places(num_views, -1);
  for (size_t i = 0; i < views.size(); ++i) places[views[i]] = static_cast<ViewId>(i);
  return places;
}

void RenumberViews(const std::vector<ViewId>& new_ids, std::vector<Curve3D>* curves) {
  for (Curve3D& curve : *curves) {
    curve.anchor.view = new_ids[curve.anchor.view];
    SupportLists support;
    std::vector<EdgelRef> of_sample;
    support.edgels.reserve(curve.support.edgels.size());
    support.offsets.reserve(curve.support.offsets.size());
    for (size_t i = 0; i < curve.size(); ++i) {
      of_sample.clear();
      for (const EdgelRef& ref : curve.support.Of(i)) {
        if (new_ids[ref.view] >= 0) of_sample.push_back({new_ids[ref.view], ref.edgel});
      }
      support.Append(of_sample);
    }
    curve.support = std::move(support);
  }
}

SketchResult SketchViews(SketchMode mode, const SketchInput& input, const SketchOptions& options,
                         ResultCache* cache, const RunContext& context, const std::string& part) {
  if (!cache->IsOn() || mode == SketchMode::kOriginal) {
    return BuildSketch(mode, input, options, context);
  }
  const SketchStore kept(mode, input, options, cache, context, part);
  ViewSketchStore store;
  store.expect = [&](size_t num_views) { cache->Expect(CachedKind::kSketch, num_views); };
  store.load = [&](ViewId v, const ViewPlan& plan) { return kept.Load(v, plan); };
  store.save = [&](ViewId v, const ViewPlan& plan, const ViewDepths& depths,
                   const std::vector<Curve3D>& curves) { kept.Save(v, plan, depths, curves); };
  return BuildSketch(mode, input, options, context, &store);
}

}  // namespace limn
