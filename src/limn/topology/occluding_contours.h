#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Whether a link is the outline of a smooth body (ours; not in the paper): no edge in
// space, but where lines of sight touch the body, another place for every view. Neighboring views
// agree on it nearly; so it is supported in a narrow part of the range of directions in which it is
// in the image. And as the body always covers the place, the views beside those see the outline
// moved to one and the same side of it. `near` holds the views that may contain the link. Time: at
// most 60 points times the square of these views.
bool IsOccludingContour(const TopologyInput& input, const DrawingLink& link,
                        const std::vector<ViewId>& near);

}  // namespace limn
