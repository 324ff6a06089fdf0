// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "bench/measures/curve_visibility.h"
#include "bench/measures/supported_curve.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Pixels are those of the virtual pinhole images.
struct HeldOutOptions {
  VisibilityOptions visibility;
  // Curve and edgel are compared if their directions in the image differ by less than this.
  double max_angle_deg = 30;
  // Larger distances, and those of samples without a partner, count as this, px.
  double cap_px = 10;
  // Edgels are compared with the curves if their fragment is at least this long, px of arc length.
  double min_fragment_length_px = 20;

  void Check() const;
};

struct ReprojectionDistances {
  // px, at most the cap; absent without samples.
  std::optional<double> median_px, p90_px;
  // Share of the samples that have no partner nearer than the cap.
  std::optional<double> lonely;
  int count = 0;
};

struct HeldOutReport {
  // From the surely visible parts of the curves, sampled every pixel, to the nearest linked edgel.
  ReprojectionDistances to_edgels;
  // From the edgels of long fragments to the nearest possibly visible part of the curves.
  ReprojectionDistances from_edgels;
};

// `training_curves[v]` belongs to `training_views[v]`, to which the curves' supporting views refer;
// the other two lists likewise, for views that the curves were not made from.
struct HeldOutInput {
  const std::vector<View>& training_views;
  const std::vector<ImageCurves>& training_curves;
  const std::vector<View>& held_out_views;
  const std::vector<ImageCurves>& held_out_curves;
};

// How well curves predict images that they were not made from (CurveVisibility). A distance is
// measured across the nearest edgel or piece of curve, plus the part along it beyond half a pixel.
// Distances of all held-out views are pooled. Throws OptionError. Time: samples times held-out
// views times training views.
HeldOutReport MeasureHeldOut(const std::vector<SupportedCurve>& curves, const HeldOutInput& input,
                             const HeldOutOptions& options, const RunContext& context);

}  // namespace limn
