// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace limn::colmap_ext {

// VisualSFM's lens, p = m (1 + r |m|^2), goes from the measured position m to the pinhole's p (both
// over the focal length, from the principal point); COLMAP's lenses go the other way. The inverse,
// m as a function of p, is not a polynomial, but the radial part of COLMAP's FULL_OPENCV,
//   m = p (1 + k1 u + k2 u^2 + k3 u^3) / (1 + k4 u + k5 u^2 + k6 u^3)   with u = |p|^2,
// fits it closely over an image.

struct FittedDistortion {
  // k1, k2, p1, p2, k3, k4, k5, k6 of FULL_OPENCV.
  std::vector<double> extra;
  // Largest error of m, over the focal length.
  double max_error = 0;
};

// Fitted by least squares for |m| <= max_radius. Nothing if the lens folds within that radius.
std::optional<FittedDistortion> InvertMeasurementDistortion(double r, double max_radius);

// The same for Brown's polynomial of four terms, which FULL_OPENCV does not have:
//   m = p (1 + k[0] u + k[1] u^2 + k[2] u^3 + k[3] u^4).
std::optional<FittedDistortion> FitRadialPolynomial(const std::array<double, 4>& k,
                                                    double max_radius);

}  // namespace limn::colmap_ext
