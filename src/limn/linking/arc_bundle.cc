// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/arc_bundle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/util/angles.h"

namespace limn {
namespace {

using Eigen::Vector2f;

constexpr int kTurns = 7;
constexpr float kEmpty = std::numeric_limits<float>::infinity();
constexpr float kMinDenominator = 1e-3f;

// The direction turned by the angle of `turn` (cosine, sine).
Vector2f Turned(const Vector2f& direction, const Vector2f& turn) {
  return {direction.x() * turn.x() - direction.y() * turn.y(),
          direction.x() * turn.y() + direction.y() * turn.x()};
}

Vector2f Reverse(const Vector2f& turn) { return {turn.x(), -turn.y()}; }

// A noisy edgel gets more slack. In white noise its direction error is about half its position
// error (radians and pixels, at sigma 1.5).
double PositionTolerance(const Edgel& edgel, const LinkingOptions& options) {
  return std::clamp(2.0 * edgel.position_sigma_px, options.position_tolerance_px,
                    std::max(options.max_position_tolerance_px, options.position_tolerance_px));
}

double AngleTolerance(const Edgel& edgel, const LinkingOptions& options) {
  const double angle = options.angle_tolerance_deg * kDeg;
  return std::clamp<double>(edgel.position_sigma_px, angle, 2 * angle);
}

// What a neighbor demands of the arcs, in the anchor's frame.
struct ArcTarget {
  Vector2f offset;
  float sign;  // of what is ahead: -1 if the neighbor is behind
  Vector2f lowest;
  Vector2f highest;  // limits of its direction
  float tolerance_px;
  float max_curvature;
};

// An arc of curvature k through the origin along t misses d by w (towards its left normal n) if
// k (|d|^2 - w^2) / 2 = d.n - w, and has direction f at d if k = sin(f - t) / (d.f), because f is
// perpendicular to the line to the center. A cell moves the origin by its shift along n.
LIMN_INLINE_KERNEL bool BundleTo(const ArcTarget& target, const ArcCells& cells,
                                 ArcBundle* bundle) {
  const Vector2f& offset = target.offset;
  const float lowest_run = offset.dot(target.lowest);
  const float highest_run = offset.dot(target.highest);
  const float miss = target.tolerance_px;
  const Float8 zero = {};
  const Float8 max_curvature = zero + target.max_curvature;
  const Float8 c = cells.turn_cos;
  const Float8 s = cells.turn_sin;
  const Float8 along = offset.x() * c + offset.y() * s;
  const Float8 across_center = offset.y() * c - offset.x() * s;
  const Float8 squared = along * along - miss * miss;
  const Float8 lowest_sin = target.lowest.y() * c - target.lowest.x() * s;
  const Float8 highest_sin = target.highest.y() * c - target.highest.x() * s;
  const Mask8 ahead = target.sign * along > zero;
  Mask8 any = {};
  for (int i = 0; i < ArcBundle::kShifts; ++i) {
    const float shift = cells.shift_px[i];
    const Float8 across = across_center - shift;
    const Float8 half = 0.5f * (squared + across * across);
    // Inside the tolerance of the anchor itself both limits lie far out.
    const Float8 per_half = 1.0f / (half > kMinDenominator ? half : zero + kMinDenominator);
    // Distances run along the limits of the direction; the formulas need them to be forward.
    const Float8 from_lowest = lowest_run - shift * lowest_sin;
    const Float8 from_highest = highest_run - shift * highest_sin;
    const Mask8 forward = ahead & (from_lowest > zero) & (from_highest > zero);
    const Float8 turned_low = lowest_sin / from_lowest;
    const Float8 turned_high = highest_sin / from_highest;
    const Float8 missed_low = (across - miss) * per_half;
    const Float8 missed_high = (across + miss) * per_half;
    const Float8 low = turned_low > missed_low ? turned_low : missed_low;
    const Float8 high = turned_high < missed_high ? turned_high : missed_high;
    const Float8 low_in_reach = low > -max_curvature ? low : -max_curvature;
    bundle->low[i] = forward ? low_in_reach : zero + kEmpty;
    bundle->high[i] = high < max_curvature ? high : max_curvature;
    any |= bundle->high[i] > bundle->low[i];
  }
  return Any8(any);
}

LIMN_FOR_AVX2 bool BundleToByAvx2(const ArcTarget& target, const ArcCells& cells,
                                  ArcBundle* bundle) {
  return BundleTo(target, cells, bundle);
}

bool BundleToBySse2(const ArcTarget& target, const ArcCells& cells, ArcBundle* bundle) {
  return BundleTo(target, cells, bundle);
}

LIMN_INLINE_KERNEL bool CommonArcs(const ArcBundle& a, const ArcBundle& b, ArcBundle* both) {
  Mask8 any = {};
  for (int i = 0; i < ArcBundle::kShifts; ++i) {
    both->low[i] = a.low[i] > b.low[i] ? a.low[i] : b.low[i];
    both->high[i] = a.high[i] < b.high[i] ? a.high[i] : b.high[i];
    any |= both->high[i] > both->low[i];
  }
  return Any8(any);
}

LIMN_FOR_AVX2 bool CommonArcsByAvx2(const ArcBundle& a, const ArcBundle& b, ArcBundle* both) {
  return CommonArcs(a, b, both);
}

bool CommonArcsBySse2(const ArcBundle& a, const ArcBundle& b, ArcBundle* both) {
  return CommonArcs(a, b, both);
}

}  // namespace

ArcSample MakeArcSample(const Edgel& edgel, const LinkingOptions& options) {
  const double step = AngleTolerance(edgel, options) / (kTurns / 2);
  ArcSample sample;
  sample.position = edgel.position_px;
  sample.tangent = edgel.Tangent().cast<float>();
  sample.turn_step = Eigen::Vector2d(std::cos(step), std::sin(step)).cast<float>();
  sample.turned_left = sample.tangent;
  sample.turned_right = sample.tangent;
  for (int i = 0; i < kTurns / 2; ++i) {
    sample.turned_left = Turned(sample.turned_left, sample.turn_step);
    sample.turned_right = Turned(sample.turned_right, Reverse(sample.turn_step));
  }
  sample.tolerance_px = static_cast<float>(PositionTolerance(edgel, options));
  return sample;
}

ArcAnchor::ArcAnchor(const ArcSample& sample, double max_curvature)
    : tangent_(sample.tangent), max_curvature_(static_cast<float>(max_curvature)) {
  for (int i = 0; i < ArcBundle::kShifts; ++i) {
    cells_.shift_px[i] = sample.tolerance_px * (2.0f * i / (ArcBundle::kShifts - 1) - 1);
  }
  const Vector2f one = sample.turn_step;
  const Vector2f two = Turned(one, one);
  const Vector2f three = Turned(two, one);
  cells_.turn_cos = Float8{three.x(), two.x(), one.x(), 1, one.x(), two.x(), three.x(), three.x()};
  cells_.turn_sin =
      Float8{-three.y(), -two.y(), -one.y(), 0, one.y(), two.y(), three.y(), three.y()};
}

bool ArcAnchor::ArcsTo(const ArcSample& other, const Vector2f& offset, ArcBundle* bundle) const {
  // What is behind is ahead of the reversed anchor. Its limits of direction change places.
  ArcTarget target;
  target.offset = offset;
  target.sign = offset.x() > 0 ? 1.f : -1.f;
  const Vector2f to_frame = target.sign * Reverse(tangent_);
  target.lowest = Turned(target.sign > 0 ? other.turned_right : other.turned_left, to_frame);
  target.highest = Turned(target.sign > 0 ? other.turned_left : other.turned_right, to_frame);
  target.tolerance_px = other.tolerance_px;
  target.max_curvature = max_curvature_;
  return HasAvx2() ? BundleToByAvx2(target, cells_, bundle)
                   : BundleToBySse2(target, cells_, bundle);
}

bool Intersect(const ArcBundle& a, const ArcBundle& b, ArcBundle* both) {
  return HasAvx2() ? CommonArcsByAvx2(a, b, both) : CommonArcsBySse2(a, b, both);
}

}  // namespace limn
