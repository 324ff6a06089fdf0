// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "limn/model/edgel_fate.h"
#include "limn/sketch/confirmation.h"
#include "limn/sketch/sketch.h"
#include "limn/sketch/sketch_edgels.h"
#include "limn/sketch/view_sketch.h"

namespace limn {

// A primary view as the depth finders use it. Holds references.
struct PrimaryView {
  PrimaryView(const SketchInput& input, ViewId id, const ViewPlan& plan, const SketchEdgels& edgels,
              const SketchOptions& options);

  // Whether sample j of a hypothesis, at this point, is supported: by enough of the views that
  // contain it, in the box, and not only within a narrow angle while views at wide angles contain
  // it (an occluding contour or an accident, algorithm/sketch.md#verdict). If so, whether it is
  // certain: enough views, weighted by tangency. By weight alone only what is certain is supported,
  // and angles do not matter.
  struct Verdict {
    bool supported = false;
    bool certain = false;
  };
  Verdict Judge(const HypothesisSupport& support, size_t j,
                const Eigen::Vector3d& point_in_cam) const;

  const SketchInput& input;
  ViewId id;
  const ViewPlan& plan;
  const SketchEdgels& edgels;
  const SketchOptions& options;
  ConfirmationViews confirmation;
  Rigid3d world_from_cam;
};

// Finds the depths of one fragment, given by vertices `spacing_px` apart, of which curves with a
// sample at every `sample_step`-th vertex are made.
struct DepthFinder {
  double spacing_px = 0;
  int sample_step = 1;
  std::function<DepthProfile(const FragmentRays&)> find;
};

// The options with which a scene of these views is sketched: a scene with few places has fewer than
// min_supporting_views others that can confirm a view; then all of them must.
SketchOptions ForScene(SketchOptions options, const std::vector<View>& views);

// Makes a sketch from local support: makes a finder for every view, runs it on every fragment that
// is long enough, and turns its depths into curves with support. `stage` names the result. Views
// are processed in parallel. Views in the store (may be null) are taken from it; the others are
// sketched in blocks, so that only the edgels of one block are in memory.
SketchResult SketchFragments(const char* stage, const SketchInput& input,
                             const SketchOptions& options, const RunContext& context,
                             const ViewSketchStore* store,
                             const std::function<DepthFinder(const PrimaryView&)>& make_finder);

}  // namespace limn
