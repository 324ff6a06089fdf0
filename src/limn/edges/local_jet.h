// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <Eigen/Core>

#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/joint_gradient.h"

namespace limn {

// Derivatives in the frame of the gradient: n along it, t = n turned so that (n, t) is a rotation.
struct LocalJet {
  double value = 0;
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double n = 0;
  double nn = 0, nt = 0, tt = 0;
  double nnn = 0, nnt = 0;
  ChannelShares shares = {1, 0, 0};
};

// n is 0, and only the value is set besides, where there is no gradient.
LocalJet AlongGradient(const Jet& jet);

// The jet of one channel that would have the same edge as the three have jointly. With l the
// squared magnitude of the joint gradient and p the angle of its normal, both functions of the
// place, an edge is the zero curve of F = grad(l) . normal; n, nn, nt, tt, nnn and nnt are such
// that l, grad(l) . normal, grad(p) and grad(F) are those of the channels. Of three channels that
// are multiples of one, it is that one's jet times the norm of the factors. The value is the first
// channel's.
LocalJet AlongJointGradient(const std::array<Jet, kMaxChannels>& jets);

}  // namespace limn
