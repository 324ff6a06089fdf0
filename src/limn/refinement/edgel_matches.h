#pragma once

#include <vector>

#include "limn/model/curve3d.h"
#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// An edgel through whose tangent line a place on a link should project.
struct EdgelPull {
  EdgelRef ref;
  // Share of an independent observation, in (0, 1].
  double weight = 1;
  double residual_px = 0;
  bool bright_left = false;  // whether the left side, walking along the link, is brighter
};

// A place on a link, at t in [0, 1] on a segment, and the edgels that pull at it: at most one per
// view, ascending by view.
struct LinkSample {
  int segment = 0;
  double t = 0;
  std::vector<EdgelPull> pulls;
};

// The samples of one link, in order.
using LinkMatches = std::vector<LinkSample>;

// Per link, the edgels that pull at its samples: the best one within the gate in every supporting
// view that shows the stretch of the link around the sample (ALGORITHM.md 16.2). An edgel that
// another link fits clearly better is not used. Time: samples times views.
std::vector<LinkMatches> MatchEdgels(const TopologyInput& input, const ControlGraph& control,
                                     const RefinementOptions& options, const RunContext& context);

}  // namespace limn
