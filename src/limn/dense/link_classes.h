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
};

// The class of every sample, and of every link that of most of its length. A sample is free if no
// dense point is near it (`near_dense`, per sample), else what most views say that see it with both
// of its sides: on a surface, or at its boundary (an occluding contour or a rim). A link is behind
// the surface by the rule of the options.
DenseClasses ClassifyLinks(const DrawingGraph& graph, const DrawingSamples& samples,
                           const std::vector<SampleEvidence>& evidence,
                           const std::vector<uint8_t>& near_dense, const DenseOptions& options);

// Total length, world units, of the samples of a class on links that are not behind the surface,
// and of the links that are.
double LengthBehind(const DrawingSamples& samples, const DenseClasses& classes);
double LengthOf(DenseClass wanted, const DrawingSamples& samples, const DenseClasses& classes);

}  // namespace limn
