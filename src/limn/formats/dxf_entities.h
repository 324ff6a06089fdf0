#pragma once

#include "limn/formats/dxf_layers.h"
#include "limn/formats/dxf_writer.h"
#include "limn/model/drawing_graph.h"

namespace limn {

constexpr const char* kDxfApplication = "LIMN";

// The entities of the model space, each with a handle from `*next_handle` on.
void PutDxfEntities(const DrawingGraph& graph, const DxfLayerPlan& plan, int model_space,
                    int* next_handle, DxfWriter* writer);

}  // namespace limn
