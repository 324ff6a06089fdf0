// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/drawing/drawing.h"
#include "limn/paper/paper_options.h"

namespace limn {

// The paper's drawing (ECCV 2016, section 3; algorithm/paper.md): builds
// the local and the curve-level consistency network of the sketch as it is, averages the curves of
// each cluster, and merges them into links. Every sample ends up in a link. `topology` says
// which links continue each other at nodes. The graph passes
// Validate().
DrawingResult BuildPaperDrawing(const DrawingInput& input, const PaperOptions& options,
                                const TopologyOptions& topology, const RunContext& context);

}  // namespace limn
