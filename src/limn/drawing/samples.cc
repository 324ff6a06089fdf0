#include "limn/drawing/samples.h"

#include <algorithm>

namespace limn {

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
