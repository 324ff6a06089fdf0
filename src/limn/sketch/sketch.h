// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/model/curves_scene.h"
#include "limn/model/edgel_fate.h"
#include "limn/model/view_subset.h"
#include "limn/sketch/sketch_options.h"
#include "limn/sketch/view_selection.h"
#include "limn/sketch/view_sketch.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// Input of every sketch generator.
struct SketchInput {
  CurvesScene scene;
  // Only these views are sketched, if they are primary; of the others only those in their plans
  // need curves. The original sketch uses all views.
  ViewSubset only = std::nullopt;
  // One per view, if they are chosen already; null: SelectViews chooses.
  const std::vector<ViewPlan>* plans = nullptr;
};

struct SketchResult {
  CurveSketch sketch;
  // Empty for the original sketch, which judges whole curves.
  EdgelFates fates;
  // Per view, the plan that was used; empty for the original sketch.
  std::vector<ViewPlan> plans;
  StageSummary summary;
};

// Keeps the sketches of views between runs. The sketch of a view depends on mode, options and box,
// on its plan, and on cameras, poses, regions and image curves of the view and of the views in its
// plan. `load` and `save` are called from several threads.
struct ViewSketchStore {
  // Called with the number of views to be sketched.
  std::function<void(size_t)> expect;
  // Empty if there is none made from the same input.
  std::function<std::optional<ViewSketch>(ViewId, const ViewPlan&)> load;
  // Of the curves of a sketch, the depths that they were made with, and their support.
  std::function<void(ViewId, const ViewPlan&, const ViewDepths&, const std::vector<Curve3D>&)> save;
};

// The swept sketch (ours; algorithm/sketch.md#swept-sketch): as the enhanced one, but every edgel
// of the primary view gets its depth from the image curves that its epipolar lines cross in all
// confirmation views at once: depths and slopes on which several views agree are chosen jointly
// along the fragment. No pair of curves must correspond over a stretch. The store is used as in the
// enhanced sketch.
SketchResult BuildSweptSketch(const SketchInput& input, const SketchOptions& options,
                              const RunContext& context, const ViewSketchStore* store = nullptr);

}  // namespace limn
