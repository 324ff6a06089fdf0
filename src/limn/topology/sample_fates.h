#pragma once

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// Tracks what becomes of every sketch sample, stage by stage.
class SampleLedger {
 public:
  // Samples in links of the graph are drawn; all others have lost their support.
  SampleLedger(const CurveSketch& sketch, const DrawingGraph& graph);

  // Assigns this fate to the samples that were in links until now and are no longer.
  void Update(const DrawingGraph& graph, EdgelFate fate_of_lost);

  const SampleFates& fates() const { return fates_; }

 private:
  SampleFates fates_;
};

}  // namespace limn
