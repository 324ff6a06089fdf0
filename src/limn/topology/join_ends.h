#pragma once

#include "limn/topology/meetings.h"

namespace limn {

// Free ends that face each other on one line become one link, or close a loop, the smallest gap
// first. What overshoots the joint is cut off. O(n log n) in the number of free ends.
void JoinFacingEnds(const TopologyInput& input, const TopologyOptions& options, const Reach& reach,
                    GraphEditor* editor, MeetingCounts* counts);

// Free ends whose lines meet become a node, at the point nearest to the lines of all its links.
// Time as above.
void JoinCorners(const TopologyInput& input, const TopologyOptions& options, const Reach& reach,
                 GraphEditor* editor, MeetingCounts* counts);

// Whether a link that comes back to itself over a gap is a loop: it is much longer than the gap.
bool MayClose(double length_px, double gap_px);

}  // namespace limn
