#pragma once

#include <optional>
#include <vector>

namespace limn::colmap_ext {

// VisualSFM's lens, p = m (1 + r |m|^2), goes from the measured position m to the pinhole's p (both
// over the focal length, from the principal point); COLMAP's lenses go the other way. The inverse
// is
//   m = p T(-r |p|^2)   with T(z) = 1 + z T(z)^3 = 1 + z + 3 z^2 + 12 z^3 + 55 z^4 + ...
// (the generating function of the ternary trees), and its [3/3] Pade approximant is a lens of
// COLMAP's FULL_OPENCV.

struct InvertedDistortion {
  // k1, k2, p1, p2, k3, k4, k5, k6 of FULL_OPENCV.
  std::vector<double> extra;
  // Largest error of the approximation, over the focal length.
  double max_error = 0;
};

// For measured positions with |m| <= max_radius. Nothing if the lens folds over within that.
std::optional<InvertedDistortion> InvertMeasurementDistortion(double r, double max_radius);

}  // namespace limn::colmap_ext
