// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace limn {

constexpr size_t kMaxChannels = 3;

// The share of every channel in the squared magnitude of a gradient; the sum is 1.
using ChannelShares = std::array<double, kMaxChannels>;

// The gradients of three channels at a place.
using ChannelGradients = std::array<Eigen::Vector2d, kMaxChannels>;

// The gradient of several channels together: of all directions, in this one (unit) the squared
// slopes of the channels sum up to the most, magnitude^2. It is the first eigenvector of the sum of
// the outer products of the gradients (Di Zenzo 1986), directed to where lightness, then green
// against red, then yellow against blue increase, in decreasing order of weight.
struct JointGradient {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double magnitude = 0;
  // The first eigenvalue less the second one.
  double gap = 0;
};

JointGradient JoinGradients(const ChannelGradients& gradients);

ChannelShares SharesOf(const ChannelGradients& gradients, const JointGradient& joint);

}  // namespace limn
