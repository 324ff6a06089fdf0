// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_fragment.h"

namespace limn {

// Fragments that other programs have linked. Linear time.

// The fragments of polylines in an image of width x height pixels: edgels at most 1 px apart, their
// tangents along the polyline, strength 1, sigma 0. A polyline whose last point equals its first is
// closed. Each must have a length.
ImageCurves CurvesOfPolylines(const std::vector<std::vector<Eigen::Vector2d>>& polylines, int width,
                              int height);

// Turns a fragment and the tangents of its edgels around, so that their other side is the brighter
// one.
void TurnAround(CurveFragment* fragment, std::vector<Edgel>* edgels);

// Gives fragments the properties that linking guarantees, and leaves those of LinkEdgels (with
// bridges of at most 10 px) as they are. Consecutive edgels are at different places and at most 10
// px apart: fragments are cut at longer gaps. An edgel is in at most one fragment, once: others get
// a copy. A fragment has at least two edgels, a closed one three. Tangents run along the fragment:
// it takes the direction of most of them, and the others are turned.
void MakeConsistent(ImageCurves* curves);

}  // namespace limn
