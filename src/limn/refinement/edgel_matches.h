#pragma once

#include <memory>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/support/view_edgels.h"
#include "limn/util/parallel.h"

namespace limn {

// An edgel that a place on a link shall pass through.
struct EdgelPull {
  EdgelRef ref;
  // How much of an independent observation it is, in (0, 1].
  double weight = 1;
  double residual_px = 0;
  bool bright_left = false;  // which side is brighter, walking along the link
};

// A place on a link, t of the way along a segment, and the edgels that pull at it: one per view at
// most, ascending by view.
struct LinkSample {
  int segment = 0;
  double t = 0;
  std::vector<EdgelPull> pulls;
};

// The samples of one link in order.
using LinkMatches = std::vector<LinkSample>;

struct MatchInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<std::unique_ptr<ViewEdgels>>& edgels;
  // Per link the views that are asked.
  const std::vector<std::vector<ViewId>>& asked;
};

// The edgels that the links should pass through, per link: the best one within the gate in every
// view that shows the stretch of the link around the sample. An edgel that another link fits
// clearly better is not taken. Time: samples times views.
std::vector<LinkMatches> MatchEdgels(const MatchInput& input, const ControlGraph& control,
                                     const SupportGate& gate, const RefinementOptions& options,
                                     const RunContext& context);

}  // namespace limn
