#pragma once

#include <vector>

#include "limn/model/edge_map.h"

namespace limn {

// Edges from a probability map, as learned detectors produce.
struct RidgeOptions {
  // Weakest edge, as a share of the full range of the map, (0, 1].
  double min_probability = 0.1;
  // Scale at which the map is smoothed, px, [0.8, 5]. Larger: less of the rounding of lines of
  // whole pixels is left, but more neighbors merge.
  double sigma_px = 1;

  // Throws OptionError.
  void Check() const;
};

// Probabilities of edges, row-major, in [0, 1]. Binary maps have 0 and 1.
struct ProbabilityMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

// Edgels on the ridges of the smoothed map: maxima along the direction across which it is most
// curved, to a fraction of a pixel. Wide and thin lines (up to some 6 px) have one ridge; plateaus
// have none, and isolated pixels neither. The strength is the probability, or what of it a line a
// pixel wide would need to have this ridge, if that is less; sigma is 0. A map does not show which
// side is brighter: tangents point to the right, or down. At most one edgel per pixel, in row-major
// order. Time: linear in pixels.
EdgeMap DetectRidges(const ProbabilityMap& map, const RidgeOptions& options);

}  // namespace limn
