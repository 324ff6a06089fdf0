// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/geometry/polyline.h"
#include "limn/model/wireframe.h"
#include "limn/util/option_fields.h"

namespace limn {

struct WireframeOptions {
  // In the unit of the polylines; 0: DefaultWireframeTolerance.
  double tolerance = 0;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("tolerance", self.tolerance, ZeroOr(Between(1e-12, 1e12)),
          "corners of a wireframe that are nearer than this are one, and curves are within half of "
          "it of their chords; in the unit that is written, or judged (m); 0 = a hundredth of the "
          "size of the scene");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
};

// A hundredth of the size of the scene: of the diagonal of the box that on each axis leaves out 2 %
// of the length at either end, so that a stray curve does not count. For a house of 15 m it is
// 0.15 m, a third of the distance by which corners are judged (evaluation/hss.h); in a photograph
// of the whole scene, ten pixels of a thousand. 0 if there is no length. O(n log n).
double DefaultWireframeTolerance(const std::vector<Polyline3d>& polylines);

// Reduces polylines to corners and straight edges (algorithm/evaluation.md#wireframes). They meet
// where they share a position.
// 1. Chains of segments, from a position where other than two meet to the next, become chords, from
//    which they are nowhere more than tolerance / 2 away.
// 2. Corners within the tolerance of another are moved to that: those of most edges stay first, of
//    these those of the smallest coordinates. Edges that are thereby equal, or points, are dropped.
// 3. Chains become chords again, as in 1: collinear edges become one. What is equal is dropped.
// So corners are more than the tolerance apart, edges longer than that, no two edges have the same
// corners, and every point of the polylines is within 2 tolerances of the wireframe; but what is
// within the tolerance of one corner, so up to 2 tolerances across, and meets nothing else
// vanishes. An edge that only passes a corner is not cut there. Corners and edges are in the order
// of coordinates: the result depends neither on the order nor the directions of the polylines, nor
// on where they are cut. Throws OptionError, or InputError if a point is not finite. O(n log n),
// quadratic at worst, as Simplified.
Wireframe ReduceToWireframe(const std::vector<Polyline3d>& polylines,
                            const WireframeOptions& options = {});

}  // namespace limn
