// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/sketch/epipolar_chords.h"
#include "limn/sketch/fragment_rays.h"

namespace limn {

// Shortest stretch over which two fragments must correspond, px of arc length in the primary view:
// shorter ones cross by chance.
inline constexpr double kMinOverlapPx = 5;

// All curve hypotheses of one primary fragment with one second view (curve sketch, CVPR 2010;
// algorithm/paper.md#hypotheses). For every vertex the epipolar line, cut to the depth range, is
// intersected with the fragments of the second view; position and tangent are interpolated at the
// intersection; runs of intersections with one fragment become hypotheses. No hypothesis leaves the
// depth range or is shorter than kMinOverlapPx. Runs end at the first vertex of a closed fragment
// of the second view unless that view's fragments are given as `seamless`. Expected time: curves on
// the epipolar lines.
std::vector<CurveHypothesis> FindHypotheses(const FragmentRays& fragment, const View& primary,
                                            const View& second,
                                            const EpipolarChords& chords_of_second,
                                            double min_depth, double max_depth,
                                            const std::vector<CurveFragment>* seamless = nullptr);

}  // namespace limn
