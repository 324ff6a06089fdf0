// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <StepShape_EdgeCurve.hxx>
#include <StepShape_VertexPoint.hxx>

#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_paths.h"

namespace limn {

// The edges of a drawing as entities of a STEP file; only for step_drawing_writer.cc.
struct StepEdges {
  std::vector<opencascade::handle<StepShape_EdgeCurve>> of_link;
  // The largest distance between a vertex and the end of a curve there.
  double gap = 0;
};

// "link_<id>", or "link_<id>_<kind>" where its kind is known; a rod's is followed by its radius in
// millimeters: "link_<id>_rod_<radius>".
std::string StepNameOf(const DrawingLink& link, LinkId id);

// Every link is directed as in its path; the edge is marked reversed where its curve runs the other
// way. Coordinates in millimeters. Throws InputError if OpenCASCADE rejects a curve.
StepEdges MakeStepEdges(const DrawingGraph& graph, const std::vector<DrawingPath>& paths);

}  // namespace limn
