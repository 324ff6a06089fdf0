// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Core>

namespace limn::testing {

// Random numbers of tests. The standard fixes std::mt19937, but not what its distributions make of
// it: with theirs, tests of fixed seeds would see other numbers with every standard library. These
// are those of GCC's.

namespace internal {

// From 0 to 1, without 1.
template <typename Real>
Real Canonical(std::mt19937& random) {
  constexpr double kRange = 4294967296;  // of the generator
  Real number;
  if constexpr (sizeof(Real) < sizeof(double)) {
    number = static_cast<Real>(random()) / static_cast<Real>(kRange);
  } else {
    const auto low = static_cast<Real>(random());
    number = (low + static_cast<Real>(random()) * kRange) / (kRange * kRange);
  }
  return number < 1 ? number : std::nextafter(Real(1), Real(0));
}

}  // namespace internal

// From `low` to `high`, without `high`.
template <typename Real>
class UniformDistribution {
 public:
  explicit UniformDistribution(Real low = 0, Real high = 1) : low_(low), high_(high) {}
  Real operator()(std::mt19937& random) const {
    return internal::Canonical<Real>(random) * (high_ - low_) + low_;
  }

 private:
  Real low_;
  Real high_;
};

// Two numbers at a time by Marsaglia's polar method.
template <typename Real>
class NormalDistribution {
 public:
  explicit NormalDistribution(Real mean = 0, Real sigma = 1) : mean_(mean), sigma_(sigma) {}
  Real operator()(std::mt19937& random) {
    has_next_ = !has_next_;
    if (!has_next_) return next_ * sigma_ + mean_;
    Real x, y, squared;
    do {
      x = static_cast<Real>(Real(2) * internal::Canonical<Real>(random) - 1.0);
      y = static_cast<Real>(Real(2) * internal::Canonical<Real>(random) - 1.0);
      squared = x * x + y * y;
    } while (squared > 1 || squared == 0);
    const Real factor = std::sqrt(-2 * std::log(squared) / squared);
    next_ = x * factor;
    return y * factor * sigma_ + mean_;
  }

 private:
  Real mean_;
  Real sigma_;
  bool has_next_ = false;
  Real next_ = 0;
};

// Three numbers, z first: in which order arguments of a function are computed is up to the
// compiler.
template <typename Distribution>
Eigen::Vector3d RandomVector(Distribution& distribution, std::mt19937& random) {
  const double z = distribution(random);
  const double y = distribution(random);
  return {distribution(random), y, z};
}

}  // namespace limn::testing
