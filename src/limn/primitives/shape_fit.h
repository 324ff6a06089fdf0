// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "limn/geometry/curve_shape.h"
#include "limn/primitives/link_samples.h"

namespace limn {

// Constraints on a shape at one of its ends.
struct EndCondition {
  // Whether the shape ends exactly at the first or last sample. Otherwise it ends where it fits
  // best.
  bool held = false;
  // Splines at held ends only: unit direction in which the spline leaves the end.
  std::optional<Eigen::Vector3d> direction = std::nullopt;
};

using EndConditions = std::array<EndCondition, 2>;

// Weighted least squares: every sample pulls at the nearest point of the shape with its `across`.
// Solved by Ceres. The links provide good starting values.

LineSegment FitLine(const LinkSamples& link, const EndConditions& ends);

// Empty if the samples do not bend.
std::optional<CircularArc> FitArc(const LinkSamples& link, const EndConditions& ends);

// Through all samples of a link that returns to its start, from near its first one or exactly from
// it. Empty if they lie on a line.
std::optional<CircularArc> FitCircle(const LinkSamples& link, bool through_first);

// With these knots (see CubicBSpline) over [0, 1]. A closed spline ends where it begins; it needs
// at least five control points.
CubicBSpline FitSpline(const LinkSamples& link, const EndConditions& ends, bool closed,
                       std::vector<double> knots);

// Distance of every sample from the shape, px: |across * (nearest point - sample)|.
std::vector<double> DeviationsPx(const CurveShape& shape, const LinkSamples& link);

// These: the weighted mean square, px^2, and the largest of samples that have full weight, px.
struct ShapeResidual {
  double mean_square = 0;
  double max_px = 0;

  double RmsPx() const { return std::sqrt(mean_square); }
};
ShapeResidual ResidualOf(const CurveShape& shape, const LinkSamples& link);

}  // namespace limn
