// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/pictures/picture.h"

namespace limn::bench {

// A drawing and a cloud of points, seen by the same camera, left and right on white. Points are
// discs of two pixels, dark when near; nearer ones cover farther ones. Only points that the view
// contains are shown.
Picture DrawSideBySide(const DrawingGraph& graph, const std::vector<Eigen::Vector3d>& cloud,
                       const View& view);

}  // namespace limn::bench
