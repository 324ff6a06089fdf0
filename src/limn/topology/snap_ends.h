#pragma once

#include "limn/topology/meetings.h"

namespace limn {

// Free ends whose line passes through a node or the inside of another link, and not along it, end
// there; the link is cut. A node a little farther away is preferred to a place on a link. Where
// links stay free their ids change. O(n log n) in the number of points.
void SnapEnds(const TopologyInput& input, const TopologyOptions& options, const Reach& reach,
              GraphEditor* editor, MeetingCounts* counts);

}  // namespace limn
