// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Per link, 1 to keep it, 0 not to (ours; algorithm/topology.md#rules). A link must stand for
// samples of at least two primary views. It is certain when enough primary views agree with it,
// averaged over its length (primary_views_share). Any other link must explain edgels that no
// certain link explains: it is kept if such edgels run along it in enough more views than edgels
// run along copies of it shifted sideways, which measure chance (own_views_share). Time: points of
// all links times views; ten times as much for uncertain links.
std::vector<uint8_t> VerifyLinks(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const DrawingGraph& graph,
                                 const RunContext& context);

}  // namespace limn
