// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/measurement_distortion.h"

#include <cmath>

#include <Eigen/Core>
#include <Eigen/QR>

namespace limn::colmap_ext {
namespace {

using Coefficients = Eigen::Matrix<double, 6, 1>;  // k1 ... k6

Eigen::ArrayXd Denominator(const Coefficients& k, const Eigen::ArrayXd& u) {
  return 1 + u * (k(3) + u * (k(4) + u * k(5)));
}

Eigen::ArrayXd Factor(const Coefficients& k, const Eigen::ArrayXd& u) {
  return (1 + u * (k(0) + u * (k(1) + u * k(2)))) / Denominator(k, u);
}

// `factor` as a function of u. The equations are multiplied by the denominator, which makes them
// linear, and their weights take it out again, as it was in the round before.
Coefficients Fit(const Eigen::ArrayXd& u, const Eigen::ArrayXd& factor,
                 const Eigen::ArrayXd& weight) {
  constexpr int kRounds = 5;
  Coefficients k = Coefficients::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, 6> matrix(u.size(), 6);
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::ArrayXd w = weight / Denominator(k, u);
    for (int power = 1; power <= 3; ++power) {
      matrix.col(power - 1) = w * u.pow(power);
      matrix.col(power + 2) = -w * factor * u.pow(power);
    }
    const Coefficients scale = matrix.colwise().norm().transpose();
    matrix = matrix * scale.cwiseInverse().asDiagonal();
    // The least solution: without distortion the two halves of the columns are the same.
    const Eigen::VectorXd right = w * (factor - 1);
    k = matrix.completeOrthogonalDecomposition().solve(right).cwiseQuotient(scale);
  }
  return k;
}

// From samples of p and m.
FittedDistortion FitSamples(const Eigen::ArrayXd& p, const Eigen::ArrayXd& m) {
  const Eigen::ArrayXd u = p.square();
  const Coefficients k = Fit(u, m / p, p);
  FittedDistortion fitted;
  fitted.extra = {k(0), k(1), 0, 0, k(2), k(3), k(4), k(5)};
  fitted.max_error = (p * Factor(k, u) - m).abs().maxCoeff();
  return fitted;
}

constexpr int kSamples = 100;

}  // namespace

std::optional<FittedDistortion> InvertMeasurementDistortion(double r, double max_radius) {
  // dp/dm > 0 up to the border.
  if (!(1 + 3 * r * max_radius * max_radius > 0)) return std::nullopt;
  const Eigen::ArrayXd m = Eigen::ArrayXd::LinSpaced(kSamples, max_radius / kSamples, max_radius);
  return FitSamples(m * (1 + r * m.square()), m);
}

std::optional<FittedDistortion> FitRadialPolynomial(const std::array<double, 4>& k,
                                                    double max_radius) {
  const auto measured = [&](double p) {
    const double u = p * p;
    return p * (1 + u * (k[0] + u * (k[1] + u * (k[2] + u * k[3]))));
  };
  constexpr double kStep = 1e-3;
  constexpr int kMaxSteps = 10000;
  double reach = 0;  // of p, where m is at the border
  for (int step = 1; measured(reach) < max_radius; ++step) {
    const double next = step * kStep * max_radius;
    if (step > kMaxSteps || !(measured(next) > measured(reach))) return std::nullopt;
    reach = next;
  }
  const Eigen::ArrayXd p = Eigen::ArrayXd::LinSpaced(kSamples, reach / kSamples, reach);
  return FitSamples(p, p.unaryExpr(measured));
}

}  // namespace limn::colmap_ext
