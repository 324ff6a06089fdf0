// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// Assigns this fate to the samples that were drawn until now and are in no link of the graph.
void UpdateFates(const DrawingGraph& graph, EdgelFate fate_of_lost, SampleFates* fates);

}  // namespace limn
