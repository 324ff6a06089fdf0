// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"

namespace limn {

// The smooth path between two free ends, from `a` to `b`, with points about 1 px apart, if it
// explains the edgels of the views that show the ends better than the straight ways to a corner do
// (ours; algorithm/topology.md#arc-or-corner). Nothing if the corner is as good. Links need
// vertices. Time: length of the ways in px times views.
std::optional<Polyline3d> ArcInsteadOfCorner(const TopologyInput& input, const GraphEditor& editor,
                                             const LinkEnd& a, const LinkEnd& b,
                                             const Eigen::Vector3d& corner);

}  // namespace limn
