#pragma once

#include "limn/drawing/draft.h"
#include "limn/model/curve3d.h"
#include "limn/model/edgel_fate.h"

namespace limn {

// Follows the samples of the sketch through the stages of the drawing.
class SampleLedger {
 public:
  explicit SampleLedger(const SampleSet& samples);

  // Samples that were in links before and are in none of the draft's now met this fate.
  void Update(const Draft& draft, EdgelFate fate_of_lost);

  // Per sample of the sketch; those that never became a sample of the drawing lost their support.
  SampleFates ForSketch(const SampleSet& samples, const CurveSketch& sketch) const;

 private:
  std::vector<EdgelFate> fates_;
};

}  // namespace limn
