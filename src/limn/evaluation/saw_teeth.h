// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/model/view.h"

namespace limn {

struct SawTeethOptions {
  // Arc length over which a curve is smoothed, pixel footprints. Longer windows detect slower teeth
  // but also count sharp bends more.
  double window_px = 15;

  void Check() const;
};

// Length of curves relative to their smoothed length: 1 is smooth, saw-teeth in depth increase it.
// Absent if no curve is as long as the window.
struct SawTeeth {
  // Over the curves, unweighted.
  std::optional<double> median, p90;
  // Over the curves, weighted by smoothed length.
  std::optional<double> median_by_length, p90_by_length;
  int num_curves = 0;  // at least as long as the window
};

// The length of a curve over the length of its running mean, where a pixel is FootprintOfCurve. The
// mean at an arc length is over the window around it, shortened symmetrically near the ends so that
// these stay in place; a closed curve is cut at its first point. A circle of radius R footprints
// gives (w/2R) / sin(w/2R): 1.02 for R = 20. Absent if the curve is shorter than the window.
std::optional<double> LengthOverSmoothed(const Polyline3d& curve, const std::vector<View>& views,
                                         const SawTeethOptions& options = {});

// Throws OptionError, or InputError if there is no view. Time: total length in footprints times the
// number of views at the middles.
SawTeeth MeasureSawTeeth(const std::vector<Polyline3d>& curves, const std::vector<View>& views,
                         const SawTeethOptions& options = {});

}  // namespace limn
