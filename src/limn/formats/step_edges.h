#pragma once

#include <vector>

#include <StepShape_EdgeCurve.hxx>
#include <StepShape_VertexPoint.hxx>

#include "limn/model/drawing_graph.h"
#include "limn/model/drawing_paths.h"

namespace limn {

// The edges of a drawing as entities of a STEP file; only for drawing_step.cc.
struct StepEdges {
  std::vector<opencascade::handle<StepShape_EdgeCurve>> of_link;
  // The largest distance between a vertex and the end of a curve there.
  double gap = 0;
};

// Every link as its path walks it: where that is against its curve, the edge says so. Coordinates
// in millimeters. Throws InputError where OpenCASCADE does not take a curve.
StepEdges MakeStepEdges(const DrawingGraph& graph, const std::vector<DrawingPath>& paths);

}  // namespace limn
