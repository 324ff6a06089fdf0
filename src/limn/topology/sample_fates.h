#pragma once

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// Follows the samples of the sketch through the stages of the drawing.
class SampleLedger {
 public:
  // All samples have lost their support, but for those in the links of the graph.
  SampleLedger(const CurveSketch& sketch, const DrawingGraph& graph);

  // Samples that were in links before and are in none of the graph's now met this fate.
  void Update(const DrawingGraph& graph, EdgelFate fate_of_lost);

  const SampleFates& fates() const { return fates_; }

 private:
  SampleFates fates_;
};

}  // namespace limn
