// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "limn/formats/dxf/layers.h"
#include "limn/formats/dxf/writer.h"
#include "limn/model/drawing_graph.h"

namespace limn {

constexpr const char* kDxfApplication = "LIMN";

// Writes the entities of the model space with handles from `*next_handle` on.
// Dimensions have functions of their own.
void PutDxfEntities(const DrawingGraph& graph, const DxfLayerPlan& plan,
                    const std::optional<DxfPlan>& flat_plan, int model_space, int* next_handle,
                    DxfWriter* writer);

}  // namespace limn
