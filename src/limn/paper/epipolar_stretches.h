// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/view.h"
#include "limn/paper/hypotheses.h"

namespace limn {

// Consecutive vertices [begin, end) of a fragment; in a closed one `end` may be beyond the last
// vertex: OpenStretch takes them modulo the size.
struct VertexStretch {
  int begin = 0;
  int end = 0;
};

// The longest stretches of a fragment along which the curve makes at least the angle of `min_sine`
// with the epipolar lines of `second` and crosses them in one direction, so that its epipolar angle
// is monotone. Those shorter than `min_length_px` are left out. Those of a closed fragment run on
// through its first vertex; only one without any break is cut there. Time O(vertices).
std::vector<VertexStretch> EpipolarStretches(const FragmentRays& fragment, const View& primary,
                                             const View& second, double min_sine,
                                             double min_length_px);

}  // namespace limn
