#pragma once

#include <string>
#include <vector>

#include "limn/formats/dxf_drawing_writer.h"
#include "limn/model/drawing_graph.h"

namespace limn {

struct DxfLayer {
  std::string name;
  int color = 7;  // AutoCAD's color index
};

// The layers that have something on them, and where things go.
struct DxfLayerPlan {
  std::vector<DxfLayer> layers;
  std::vector<int> of_link;
  int of_junctions = -1;  // -1: they are not drawn
};

DxfLayerPlan PlanDxfLayers(const DrawingGraph& graph, const DxfOptions& options);

}  // namespace limn
