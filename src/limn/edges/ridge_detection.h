// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edge_map.h"
#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

// Edges from a probability map, as learned detectors produce.
struct RidgeOptions {
  double min_probability = 0.1;
  // Larger: less of the rounding of lines of whole pixels is left, but more neighbors merge.
  double sigma_px = 1;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("min_probability", self.min_probability, Above(0, 1),
          "edges_path: weakest edge in maps, share of their full range");
    visit("sigma_px", self.sigma_px, Between(0.8, 5),
          "edges_path: scale at which maps are smoothed, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
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
