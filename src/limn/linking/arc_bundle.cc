#include "limn/linking/arc_bundle.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const double angle = options.angle_tolerance_deg * M_PI / 180;
  return std::clamp<double>(edgel.position_sigma_px, angle, 2 * angle);
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
    shift_px_[i] = sample.tolerance_px * (2.0f * i / (ArcBundle::kShifts - 1) - 1);
  }
  const Vector2f one = sample.turn_step;
  const Vector2f two = Turned(one, one);
  const Vector2f three = Turned(two, one);
  turn_cos_[0] = Float4{three.x(), two.x(), one.x(), 1};
  turn_sin_[0] = Float4{-three.y(), -two.y(), -one.y(), 0};
  turn_cos_[1] = Float4{one.x(), two.x(), three.x(), three.x()};
  turn_sin_[1] = Float4{one.y(), two.y(), three.y(), three.y()};
}

ArcBundle ArcAnchor::AllArcs() const {
  ArcBundle bundle;
  for (int i = 0; i < ArcBundle::kShifts; ++i) {
    for (int v = 0; v < ArcBundle::kTurnVectors; ++v) {
      bundle.low[i][v] = Splat4(-max_curvature_);
      bundle.high[i][v] = Splat4(max_curvature_);
    }
  }
  return bundle;
}

// An arc of curvature k through the origin along t misses d by w (towards its left normal n) if
// k (|d|^2 - w^2) / 2 = d.n - w, and has direction f at d if k = sin(f - t) / (d.f), because f is
// perpendicular to the line to the centre. A cell moves the origin by its shift along n.
ArcBundle ArcAnchor::ArcsTo(const ArcSample& other, const Vector2f& offset) const {
  // What is behind is ahead of the reversed anchor. Its limits of direction change places.
  const float sign = offset.x() > 0 ? 1.f : -1.f;
  const Vector2f to_frame = sign * Reverse(tangent_);
  const Vector2f lowest = Turned(sign > 0 ? other.turned_right : other.turned_left, to_frame);
  const Vector2f highest = Turned(sign > 0 ? other.turned_left : other.turned_right, to_frame);
  const float lowest_run = offset.dot(lowest);
  const float highest_run = offset.dot(highest);
  const float miss = other.tolerance_px;
  const Float4 zero = Splat4(0);

  ArcBundle bundle;
  for (int v = 0; v < ArcBundle::kTurnVectors; ++v) {
    const Float4 c = turn_cos_[v];
    const Float4 s = turn_sin_[v];
    const Float4 along = offset.x() * c + offset.y() * s;
    const Float4 across_centre = offset.y() * c - offset.x() * s;
    const Float4 squared = along * along - miss * miss;
    const Float4 lowest_sin = lowest.y() * c - lowest.x() * s;
    const Float4 highest_sin = highest.y() * c - highest.x() * s;
    const auto ahead = sign * along > zero;
    for (int i = 0; i < ArcBundle::kShifts; ++i) {
      const float shift = shift_px_[i];
      const Float4 across = across_centre - shift;
      const Float4 half = 0.5f * (squared + across * across);
      // Inside the tolerance of the anchor itself both limits lie far out.
      const Float4 per_half = 1.0f / Max4(half, Splat4(kMinDenominator));
      // Distances run along the limits of the direction; the formulas need them to be forward.
      const Float4 from_lowest = lowest_run - shift * lowest_sin;
      const Float4 from_highest = highest_run - shift * highest_sin;
      const auto forward = ahead & (Min4(from_lowest, from_highest) > zero);
      const Float4 low = Max4(lowest_sin / from_lowest, (across - miss) * per_half);
      bundle.low[i][v] = forward ? low : Splat4(kEmpty);
      bundle.high[i][v] = Min4(highest_sin / from_highest, (across + miss) * per_half);
    }
  }
  return bundle;
}

bool Intersect(const ArcBundle& a, const ArcBundle& b, ArcBundle* both) {
  auto any = Splat4(0) > Splat4(0);
  for (int i = 0; i < ArcBundle::kShifts; ++i) {
    for (int v = 0; v < ArcBundle::kTurnVectors; ++v) {
      both->low[i][v] = Max4(a.low[i][v], b.low[i][v]);
      both->high[i][v] = Min4(a.high[i][v], b.high[i][v]);
      any |= both->high[i][v] > both->low[i][v];
    }
  }
  return (any[0] | any[1] | any[2] | any[3]) != 0;
}

}  // namespace limn
