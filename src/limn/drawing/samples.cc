#include "limn/drawing/samples.h"

#include <cmath>

namespace limn {

void Reserve(size_t num_samples, size_t num_edgels, SampleSet* samples) {
  samples->curve_of.reserve(num_samples);
  samples->position.reserve(num_samples);
  samples->tangent.reserve(num_samples);
  samples->information.reserve(num_samples);
  samples->footprint.reserve(num_samples);
  samples->support.offsets.reserve(num_samples + 1);
  samples->support.edgels.reserve(num_edgels);
}

std::vector<double> ArcPx(const SampleSet& samples, int curve) {
  const int begin = samples.curve_begin[curve];
  std::vector<double> arc(samples.Size(curve), 0.0);
  for (size_t k = 1; k < arc.size(); ++k) {
    const int i = begin + static_cast<int>(k);
    arc[k] = arc[k - 1] + (samples.position[i] - samples.position[i - 1]).norm() /
                              (0.5 * (samples.footprint[i] + samples.footprint[i - 1]));
  }
  return arc;
}

}  // namespace limn
