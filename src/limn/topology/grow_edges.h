// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/joints.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Where grown edges may end.
enum class GrowthEnd { kAnywhere, kJoint };

// Adds straight links for edges that leave a joint and that the sketch lacks, because they are too
// short or too broken in the images: the height of a step, a seam (ours;
// algorithm/topology.md#growth). The best direction in which image edges leave the joint
// (FindJointDirection) is followed as long as half of its views have edgels there; a joint that it
// reaches ends it. The link is kept if edgels run along it (FindSegmentSupport) in more views than
// chance explains, in one of them edgels that no link has yet; then the next direction is tried.
// Nothing grows out of the box, except to a joint there. Returns the number of links added. Time
// per joint: see FindJointDirection.
int64_t GrowEdges(const TopologyInput& input, const TopologyOptions& options, GrowthEnd ends,
                  const RunContext& context, GraphEditor* editor);

// Adds straight links between joints at most max_short_edge_px apart, neither with a link in that
// direction, where edgels run along the segment in enough views, as above
// (algorithm/topology.md#short-edges). Returns the number of links added.
int64_t AddShortEdges(const TopologyInput& input, const TopologyOptions& options,
                      const RunContext& context, GraphEditor* editor);

}  // namespace limn
