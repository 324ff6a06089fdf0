// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// The supporting views of the links are ids of the scene's views. The graph passes Validate().
struct RefinementInput {
  CurvesScene scene;
  const DrawingGraph& graph;
};

}  // namespace limn
