#pragma once

#include <vector>

#include <StepShape_EdgeCurve.hxx>
#include <StepShape_VertexPoint.hxx>

#include "limn/model/drawing_graph.h"

namespace limn {

// The edges of a drawing as entities of a STEP file; only for drawing_step.cc.
struct StepEdges {
  std::vector<opencascade::handle<StepShape_EdgeCurve>> of_link;
  // The largest distance between a vertex and the end of a curve there.
  double gap = 0;
};

// Coordinates in millimetres. Throws InputError where OpenCASCADE does not take a curve.
StepEdges MakeStepEdges(const DrawingGraph& graph);

}  // namespace limn
