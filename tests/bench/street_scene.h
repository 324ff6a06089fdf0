// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "bench/scene.h"
#include "limn/model/curve_set.h"

namespace limn::bench {

struct StreetOptions {
  int num_views = 100;
  // Per view on average; 150,000 is what dense photographs of 12 megapixels have.
  int num_edgels = 20000;
  // Of the edgels, across the edge.
  double noise_px = 0;
  int seed = 1;

  // Throws OptionError.
  void Check() const;
};

// A scene whose size grows with the number of views.
struct Street {
  Scene scene;  // without image curves
  // Makes the image curves of a view; several threads may.
  std::function<ImageCurves(ViewId)> curves_of;
  // The parts of the curves that at least 4 views contain.
  CurveSet truth;
  // Of a pixel, meters, in the middle of the curves.
  double footprint = 0;
};

// Cameras of 4000 x 3000 px walk along one side of a street, 0.9 m apart, and look at the other
// side 11 m away, where smooth curves of 0.7 to 2.3 m float in a slab: each view shares what it
// sees with some 30 others, whatever the length of the street. Edgels are those of the curves,
// exact except for the noise; nothing hides anything; the hints are three points of each curve.
// Linear in views times edgels.
Street MakeStreet(const StreetOptions& options);

}  // namespace limn::bench
