// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/dense/dense_options.h"
#include "limn/dense/sample_sights.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Relation of a drawing to a dense surface.
struct DenseClasses {
  std::vector<LinkDense> links;          // as in the graph
  std::vector<DenseClass> sample_class;  // as the samples
  std::vector<uint8_t> near_dense;       // as the samples
};

// Classifies every sample and every link, which gets the class of most of its length
// (algorithm/dense.md#classes). A sample that touches the surface, at the resolution of the views'
// depths, is on the surface or at its boundary (an occluding contour or a rim), whichever most
// views say that know both of its sides. Other samples that a view sees are free. Whether a link is
// behind the surface follows from the options. `near_dense` tells per sample whether a dense point
// is within near_px; in a sparse cloud this is rare on the surface, too.
DenseClasses ClassifyLinks(const DrawingGraph& graph, const DrawingSamples& samples,
                           const std::vector<SampleSupport>& support,
                           std::vector<uint8_t> near_dense, const DenseOptions& options);

// Total lengths, world units: of the links behind the surface; and, of the other links, of the
// samples of a class and of those without a dense point nearby.
double LengthBehind(const DrawingSamples& samples, const DenseClasses& classes);
double LengthOf(DenseClass wanted, const DrawingSamples& samples, const DenseClasses& classes);
double LengthAdded(const DrawingSamples& samples, const DenseClasses& classes);

}  // namespace limn
