#include "limn/drawing/samples.h"

#include <algorithm>

namespace limn {

void RecomputeTangents(const SampleSet& samples, int curve,
                       std::vector<Eigen::Vector3d>* tangents) {
  const int begin = samples.curve_begin[curve];
  const int size = samples.Size(curve);
  const bool closed = samples.origins[curve].closed;
  for (int k = 0; k < size; ++k) {
    const int before = closed ? (k + size - 1) % size : std::max(k - 1, 0);
    const int after = closed ? (k + 1) % size : std::min(k + 1, size - 1);
    const Eigen::Vector3d chord =
        samples.position[begin + after] - samples.position[begin + before];
    if (chord.norm() > 0) (*tangents)[begin + k] = chord.normalized();
  }
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
