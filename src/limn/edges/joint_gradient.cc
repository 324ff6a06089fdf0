// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/joint_gradient.h"

#include <cmath>

namespace limn {
namespace {

using Eigen::Vector2d;

// The side of an edge that counts as the bright one, in Lab: no color of an edge that is frequent
// in pictures is near the plane where the sign changes.
constexpr std::array<double, kMaxChannels> kRise = {1, -0.5, 0.5};

// The first eigenvector of (a b; b c), the first eigenvalue given: of the two rows that it is
// orthogonal to, the one that does not cancel.
Vector2d FirstEigenvector(double a, double b, double c, double eigenvalue) {
  const Vector2d vector = a >= c ? Vector2d(eigenvalue - c, b) : Vector2d(b, eigenvalue - a);
  const double norm = vector.norm();
  return norm > 0 ? Vector2d(vector / norm) : Vector2d::UnitX();
}

}  // namespace

JointGradient JoinGradients(const ChannelGradients& gradients) {
  double a = 0;
  double b = 0;
  double c = 0;
  Vector2d rise = Vector2d::Zero();
  for (size_t k = 0; k < kMaxChannels; ++k) {
    const Vector2d& g = gradients[k];
    a += g.x() * g.x();
    b += g.x() * g.y();
    c += g.y() * g.y();
    rise += kRise[k] * g;
  }
  JointGradient joint;
  joint.gap = std::sqrt((a - c) * (a - c) + 4 * b * b);
  const double eigenvalue = (a + c + joint.gap) / 2;
  joint.magnitude = std::sqrt(eigenvalue);
  joint.normal = FirstEigenvector(a, b, c, eigenvalue);
  if (joint.normal.dot(rise) < 0) joint.normal = -joint.normal;
  return joint;
}

ChannelShares SharesOf(const ChannelGradients& gradients, const JointGradient& joint) {
  ChannelShares shares{};
  for (size_t k = 0; k < kMaxChannels; ++k) {
    const double share = gradients[k].dot(joint.normal) / joint.magnitude;
    shares[k] = share * share;
  }
  return shares;
}

}  // namespace limn
