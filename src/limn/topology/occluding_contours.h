#pragma once

#include <optional>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Nothing, or the confidence with which a link is the outline of a smooth body (ours;
// algorithm/topology.md#occluding-contours): not an edge in space but the points where lines of
// sight touch the body, which differ from view to view. Neighboring views nearly agree on it, so
// only a narrow range of viewing directions supports it; and since the body always covers the
// place, views beside those see the outline shifted to the same side. The confidence is the share
// of those views that do, by the rule of succession, those without an outline counting by half.
// `near` holds the views that may contain the link. Time: at most 60 points times the square of
// these views.
std::optional<double> ContourConfidence(const TopologyInput& input, const DrawingLink& link,
                                        const std::vector<ViewId>& near);

}  // namespace limn
