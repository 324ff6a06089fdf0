#pragma once

#include <vector>

#include "limn/model/curve3d.h"
#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_input.h"
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

// The edgels that the links should pass through, per link: the best one within the gate in every
// asked view that shows the stretch of the link around the sample. An edgel that another link fits
// clearly better is not taken. Time: samples times views.
std::vector<LinkMatches> MatchEdgels(const TopologyInput& input, const ControlGraph& control,
                                     const RefinementOptions& options, const RunContext& context);

}  // namespace limn
