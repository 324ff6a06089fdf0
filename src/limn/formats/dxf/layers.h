// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/formats/dxf/options.h"
#include "limn/model/drawing_graph.h"

namespace limn {

constexpr const char* kDxfDimensionLayer = "dimensions";

enum class DxfLineType { kContinuous, kHidden, kCenter, kDotted };

// "Continuous", "HIDDEN", "CENTER", "DOT".
const char* DxfLineTypeName(DxfLineType type);

struct DxfLayer {
  std::string name;
  int color = 7;  // AutoCAD's color index
  DxfLineType line_type = DxfLineType::kContinuous;
  // Hundredths of a millimeter, one of AutoCAD's.
  int line_weight = 25;
};

// The nonempty layers, that of the sheet (kDxfSheetLayer) of a plan last, and the layer of every
// link, of every face and of the junctions.
struct DxfLayerPlan {
  std::vector<DxfLayer> layers;
  std::vector<int> of_link;
  std::vector<int> of_face;
  // -1: not drawn.
  int of_junctions = -1;
  int of_hidden = -1;
  int of_section = -1;
  int of_section_points = -1;
};

DxfLayerPlan PlanDxfLayers(const DrawingGraph& graph, const DxfOptions& options);

}  // namespace limn
