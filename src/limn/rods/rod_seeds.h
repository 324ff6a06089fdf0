// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/rods/rod.h"
#include "limn/util/parallel.h"

namespace limn {

struct RodSeed {
  Rod rod;
  std::vector<ViewId> views;  // that support either link, ascending
};

// Rods that pairs of links suggest: believed links that run beside each other for at least 12 px,
// as far apart as the outlines of a rod can be. The axis is in the middle between them. At most one
// rod per pair. Time: length of all links in px times links near each other.
std::vector<RodSeed> FindRodSeeds(const std::vector<View>& views, const DrawingGraph& graph,
                                  const RunContext& context);

}  // namespace limn
