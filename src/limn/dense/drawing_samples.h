// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// Points evenly spread over all links of a drawing, link by link.
struct DrawingSamples {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> tangent;  // unit
  std::vector<double> footprint;         // world units per px (LinkFootprint)
  std::vector<double> length;            // of the piece of the link that the sample represents
  std::vector<LinkId> link;

  size_t size() const { return position.size(); }
};

// Samples at most `spacing_px` footprints apart, without the ends of the links, which other links
// share. Links that no view sees have none.
DrawingSamples SampleDrawing(const DrawingGraph& graph, const std::vector<View>& views,
                             double spacing_px);

}  // namespace limn
