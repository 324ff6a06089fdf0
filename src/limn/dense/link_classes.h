#pragma once

#include <cstdint>
#include <vector>

#include "limn/dense/dense_options.h"
#include "limn/dense/sample_sights.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// What a drawing has to do with a dense surface.
struct DenseClasses {
  std::vector<LinkDense> links;          // as in the graph
  std::vector<DenseClass> sample_class;  // as the samples
  std::vector<uint8_t> near_dense;       // as the samples
};

// The class of every sample, and of every link that of most of its length. A sample that touches
// the surface, at the resolution at which the views know it, is what most views say that see it
// with both of its sides: on the surface, or at its boundary (an occluding contour or a rim). One
// that does not is free. A link is behind the surface by the rule of the options. `near_dense`:
// whether a dense point is within near_px, per sample; with a thin cloud that is seldom so on the
// surface, too.
DenseClasses ClassifyLinks(const DrawingGraph& graph, const DrawingSamples& samples,
                           const std::vector<SampleSupport>& support,
                           std::vector<uint8_t> near_dense, const DenseOptions& options);

// Total lengths, world units: of the links behind the surface; of the other links the samples of a
// class, and those without a dense point near.
double LengthBehind(const DrawingSamples& samples, const DenseClasses& classes);
double LengthOf(DenseClass wanted, const DrawingSamples& samples, const DenseClasses& classes);
double LengthAdded(const DrawingSamples& samples, const DenseClasses& classes);

}  // namespace limn
