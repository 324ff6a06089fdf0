#pragma once

#include <vector>

#include "limn/linking/linking.h"
#include "limn/util/float4.h"

namespace limn {

// What an arc that passes an edgel must meet: its place and direction, up to the tolerances.
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

// An interval of curvatures, 1/px, for every perturbation (a cell) of an anchor: its position
// across the curve times its direction. Empty where low >= high.
struct ArcBundle {
  static constexpr int kShifts = 9;
  // Seven, of which the last is there twice, to make two vectors of four.
  static constexpr int kTurnVectors = 2;

  Float4 low[kShifts][kTurnVectors];
  Float4 high[kShifts][kTurnVectors];
};

// Arcs through an anchor, in its frame: x along its tangent, y across, towards the left with y up.
class ArcAnchor {
 public:
  ArcAnchor(const ArcSample& sample, double max_curvature);

  // All arcs that are not too sharp.
  ArcBundle AllArcs() const;
  // Those that meet another sample, which is at `offset` in the anchor's frame, whatever their
  // curvature.
  ArcBundle ArcsTo(const ArcSample& other, const Eigen::Vector2f& offset) const;

 private:
  Eigen::Vector2f tangent_;
  float max_curvature_;
  float shift_px_[ArcBundle::kShifts];
  Float4 turn_cos_[ArcBundle::kTurnVectors];
  Float4 turn_sin_[ArcBundle::kTurnVectors];
};

// The arcs in both bundles. Returns whether there are any.
bool Intersect(const ArcBundle& a, const ArcBundle& b, ArcBundle* both);

}  // namespace limn
