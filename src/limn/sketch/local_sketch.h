#pragma once

#include <functional>
#include <vector>

#include "limn/model/edgel_fate.h"
#include "limn/sketch/confirmation.h"
#include "limn/sketch/depth_fusion.h"
#include "limn/sketch/sketch.h"
#include "limn/sketch/sketch_edgels.h"

namespace limn {

// What a generator of depths knows of its primary view. Holds references.
struct PrimaryView {
  PrimaryView(const SketchInput& input, ViewId id, const ViewPlan& plan, const SketchEdgels& edgels,
              const SketchOptions& options);

  // Whether sample j of a hypothesis, at this point, is supported: by enough of the views that
  // contain it, in the box, and not only within a narrow angle while views at wide angles contain
  // it (an occluding contour or an accident, ALGORITHM.md 5.3). If so, whether it is certain:
  // enough views, weighted by tangency.
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

// Depths of the samples of a fragment, and why there is none.
struct DepthProfile {
  std::vector<FusedDepth> depths;
  std::vector<EdgelFate> fates;  // kNoPartner, kTooFewViews or kInconsistent where there is none
};

// Finds the depths of one fragment, given by samples `spacing_px` apart.
struct DepthFinder {
  double spacing_px = 0;
  std::function<DepthProfile(const FragmentRays&)> find;
};

// The sketch whose depths come from local support: for every view a finder is made, asked for every
// fragment that is long enough, and what it finds becomes curves with their support. `stage` names
// the result. Calls for different views run in parallel. Views that the store (may be null) has are
// taken from it; the others are sketched in blocks, whose edgels are all that is held.
SketchResult SketchFragments(const char* stage, const SketchInput& input,
                             const SketchOptions& options, const RunContext& context,
                             const ViewSketchStore* store,
                             const std::function<DepthFinder(const PrimaryView&)>& make_finder);

}  // namespace limn
