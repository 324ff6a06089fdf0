// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/linking/linking_options.h"
#include "limn/model/curve_fragment.h"
#include "limn/util/float8.h"

namespace limn {

// What an arc through an edgel must meet within the tolerances: its position and direction.
struct ArcSample {
  Eigen::Vector2d position;
  Eigen::Vector2f tangent;
  // The tangent turned by the tolerance, clockwise and counter-clockwise with y up.
  Eigen::Vector2f turned_right;
  Eigen::Vector2f turned_left;
  // Cosine and sine of the turn from one cell of a bundle to the next.
  Eigen::Vector2f turn_step;
  float tolerance_px;
};

ArcSample MakeArcSample(const Edgel& edgel, const LinkingOptions& options);

// An interval of curvatures, 1/px, for every perturbation (cell) of an anchor: shifts across the
// curve times turns. Empty where low >= high.
struct ArcBundle {
  static constexpr int kShifts = 9;
  // Seven turns, of which the last is stored twice.
  Float8 low[kShifts];
  Float8 high[kShifts];
};

// The perturbations of an anchor.
struct ArcCells {
  float shift_px[ArcBundle::kShifts];
  Float8 turn_cos;
  Float8 turn_sin;
};

// Arcs through an anchor, in its frame: x along its tangent, y across, to the left with y up.
class ArcAnchor {
 public:
  ArcAnchor(const ArcSample& sample, double max_curvature);

  // The arcs within the curvature limit that meet another sample, which is at `offset` in the
  // anchor's frame. Returns whether there are any.
  bool ArcsTo(const ArcSample& other, const Eigen::Vector2f& offset, ArcBundle* bundle) const;

 private:
  Eigen::Vector2f tangent_;
  float max_curvature_;
  ArcCells cells_;
};

// Intersects two bundles. Returns whether any arc is left.
bool Intersect(const ArcBundle& a, const ArcBundle& b, ArcBundle* both);

}  // namespace limn
