#include "colmap_ext/import/measurement_distortion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

namespace limn::colmap_ext {
namespace {

// T(z) = (a0 + a1 z + a2 z^2 + a3 z^3) / (1 + b1 z + b2 z^2 + b3 z^3), equal in the terms up to
// z^6.
struct Pade {
  std::array<double, 4> a;
  std::array<double, 4> b;
};

Pade TernaryTreePade() {
  // binomial(3 n, n) / (2 n + 1)
  constexpr std::array<double, 7> kSeries = {1, 1, 3, 12, 55, 273, 1428};
  Eigen::Matrix3d matrix;
  Eigen::Vector3d right;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix(row, column) = kSeries[3 + row - column];
    right(row) = -kSeries[4 + row];
  }
  const Eigen::Vector3d b = matrix.partialPivLu().solve(right);
  Pade pade = {{}, {1, b(0), b(1), b(2)}};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k <= i; ++k) pade.a[i] += pade.b[k] * kSeries[i - k];
  }
  return pade;
}

double Polynomial(const std::array<double, 4>& c, double x) {
  return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

}  // namespace

std::optional<InvertedDistortion> InvertMeasurementDistortion(double r, double max_radius) {
  // dp/dm > 0 up to the border.
  if (!(1 + 3 * r * max_radius * max_radius > 0)) return std::nullopt;
  static const Pade kPade = TernaryTreePade();
  const double z = -r;  // per |p|^2
  const auto k = [z](const std::array<double, 4>& c, int n) { return c[n] * std::pow(z, n); };
  InvertedDistortion inverted;
  inverted.extra = {k(kPade.a, 1), k(kPade.a, 2), 0, 0, k(kPade.a, 3), k(kPade.b, 1),
                    k(kPade.b, 2), k(kPade.b, 3)};
  constexpr int kSteps = 1000;
  for (int i = 1; i <= kSteps; ++i) {
    const double m = max_radius * i / kSteps;
    const double p = m * (1 + r * m * m);
    const double again = p * Polynomial(kPade.a, z * p * p) / Polynomial(kPade.b, z * p * p);
    inverted.max_error = std::max(inverted.max_error, std::abs(again - m));
  }
  return inverted;
}

}  // namespace limn::colmap_ext
