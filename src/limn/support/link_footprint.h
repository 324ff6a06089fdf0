#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// World units per px at a point of a link: the median over its supporting views, or over all where
// those do not see it; 0 if no view does.
double LinkFootprint(const DrawingLink& link, const Eigen::Vector3d& point,
                     const std::vector<View>& views);

}  // namespace limn
