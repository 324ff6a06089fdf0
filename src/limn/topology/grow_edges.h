#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include "limn/topology/joints.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Edges that leave a joint and that the sketch does not have, because they are too short or too
// broken in the images for fragments of their own, or that it lost on the way: the height of a
// step, a seam. The best direction in which image edges leave the joint (FindCornerDirection) grows
// into a straight link as far as half of the views that show it have edgels there, and ends at a
// joint that it reaches. It is kept if edgels run along it (FindSegmentSupport) in so many views
// that chance is no explanation, in one of them edgels that no link has yet; then the next
// direction is tried. Nothing grows out of the box, unless to a joint there. Ours; not in the
// paper. Returns the number of links added. Time per joint: see FindCornerDirection.
int64_t GrowEdges(const TopologyInput& input, const TopologyOptions& options,
                  const std::optional<Eigen::AlignedBox3d>& box, const RunContext& context,
                  GraphEditor* editor);

// Edges of which both ends are joints already, at most max_short_edge_px apart, with no link
// leaving either in that direction: straight links where edgels run along the segment in enough
// views, as above. Returns the number of links added.
int64_t AddShortEdges(const TopologyInput& input, const TopologyOptions& options,
                      const RunContext& context, GraphEditor* editor);

}  // namespace limn
