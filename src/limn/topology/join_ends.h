// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/topology/meetings.h"

namespace limn {

// Joins free ends that face each other on one line into one link, or closes a loop, smallest gap
// first; points that overshoot the joint are dropped (algorithm/topology.md#facing-ends). O(n log
// n) in the number of free ends.
void JoinFacingEnds(const MeetingTask& task);

// Joins free ends whose lines meet into a node at the point nearest to all their lines
// (algorithm/topology.md#corners). Time as above.
void JoinCorners(const MeetingTask& task);

// Returns whether a link may close over a gap between its own ends: it must be much longer than the
// gap.
bool MayClose(double length_px, double gap_px);

}  // namespace limn
