// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/surfaces/face_evidence.h"
#include "limn/surfaces/surface_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct SurfaceResult {
  DrawingGraph graph;                // with faces
  std::vector<LinkId> links_behind;  // LinksBehindFaces
  StageSummary summary;
};

// Finds the surfaces that the links of a drawing bound (ours; algorithm/surfaces.md) and replaces
// the drawing's faces by them: regions of planes surrounded by links, where the views' evidence
// about the border and about curves behind agrees with a surface. Links and nodes stay as they are.
// Within the gate, that of the refinement, an edgel shows a link.
// The result does not depend on the number of threads. Throws OptionError and Cancelled.
SurfaceResult FindFaces(const CurvesScene& scene, const SupportGate& gate,
                        const DrawingGraph& graph, const SurfaceOptions& options,
                        const RunContext& context);

}  // namespace limn
