#include "limn/drawing/sample_fates.h"

namespace limn {

SampleLedger::SampleLedger(const SampleSet& samples)
    : fates_(samples.NumSamples(), EdgelFate::kDrawn) {}

void SampleLedger::Update(const Draft& draft, EdgelFate fate_of_lost) {
  std::vector<uint8_t> in_link(fates_.size(), 0);
  for (const DraftLink& link : draft.links) {
    for (const auto& of_point : link.samples) {
      for (const int s : of_point) {
        if (s < draft.num_sketch_samples) in_link[s] = 1;
      }
    }
  }
  for (size_t s = 0; s < fates_.size(); ++s) {
    if (fates_[s] == EdgelFate::kDrawn && !in_link[s]) fates_[s] = fate_of_lost;
  }
}

SampleFates SampleLedger::ForSketch(const SampleSet& samples, const CurveSketch& sketch) const {
  SampleFates result;
  for (const Curve3D& curve : sketch.curves) {
    result.emplace_back(curve.size(), EdgelFate::kLostSupport);
  }
  for (size_t s = 0; s < fates_.size(); ++s) {
    const int curve = samples.curve_of[s];
    const CurveOrigin& origin = samples.origins[curve];
    const int k = static_cast<int>(s) - samples.curve_begin[curve];
    result[origin.sketch_curve][origin.begin + k] = fates_[s];
  }
  return result;
}

}  // namespace limn
