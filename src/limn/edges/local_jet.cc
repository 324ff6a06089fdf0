// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/local_jet.h"

#include <cmath>

namespace limn {
namespace {

using Eigen::Vector2d;

// Fills the derivatives of second and third order in the frame whose first axis is (c, s).
void Rotate(const Jet& jet, double c, double s, LocalJet* local) {
  local->nn = c * c * jet.xx + 2 * c * s * jet.xy + s * s * jet.yy;
  local->nt = c * s * (jet.yy - jet.xx) + (c * c - s * s) * jet.xy;
  local->tt = s * s * jet.xx - 2 * c * s * jet.xy + c * c * jet.yy;
  local->nnn =
      c * c * c * jet.xxx + 3 * c * c * s * jet.xxy + 3 * c * s * s * jet.xyy + s * s * s * jet.yyy;
  local->nnt = -c * c * s * jet.xxx + c * (c * c - 2 * s * s) * jet.xxy +
               s * (2 * c * c - s * s) * jet.xyy + c * s * s * jet.yyy;
}

// Derivatives of the tensor's entries a (n, n) and b (n, t), summed over the channels, halved where
// a product rule doubles them: a_n is half the derivative of a along n.
struct TensorDerivatives {
  double a_n = 0, a_t = 0;
  double a_nn = 0, a_nt = 0;
  double b_n = 0, b_t = 0;

  // A channel with slopes n and t in the frame.
  void Add(const LocalJet& channel, double n, double t) {
    a_n += n * channel.nn;
    a_t += n * channel.nt;
    a_nn += channel.nn * channel.nn + n * channel.nnn;
    a_nt += channel.nn * channel.nt + n * channel.nnt;
    b_n += channel.nn * t + n * channel.nt;
    b_t += channel.nt * t + n * channel.tt;
  }
};

}  // namespace

LocalJet AlongGradient(const Jet& jet) {
  LocalJet local;
  local.value = jet.value;
  local.n = std::sqrt(jet.x * jet.x + jet.y * jet.y);
  if (local.n == 0) return local;
  const double c = jet.x / local.n;
  const double s = jet.y / local.n;
  local.normal = {c, s};
  Rotate(jet, c, s, &local);
  return local;
}

LocalJet AlongJointGradient(const std::array<Jet, kMaxChannels>& jets) {
  ChannelGradients gradients;
  for (size_t k = 0; k < kMaxChannels; ++k) gradients[k] = {jets[k].x, jets[k].y};
  const JointGradient joint = JoinGradients(gradients);
  LocalJet local;
  local.value = jets[0].value;
  if (joint.gap == 0) return local;
  const Vector2d& normal = joint.normal;
  const Vector2d tangent(-normal.y(), normal.x());
  TensorDerivatives of;
  for (size_t k = 0; k < kMaxChannels; ++k) {
    LocalJet channel;
    Rotate(jets[k], normal.x(), normal.y(), &channel);
    of.Add(channel, gradients[k].dot(normal), gradients[k].dot(tangent));
  }
  // In its own frame the tensor has b = 0; its first eigenvalue l and the angle p of the first
  // eigenvector change, by perturbation, with l_x = a_x, l_xy = a_xy + 2 b_x b_y / gap and p_x =
  // b_x / gap. These are halves.
  const double l_nn = of.a_nn + of.b_n * of.b_n / joint.gap;
  const double l_nt = of.a_nt + of.b_n * of.b_t / joint.gap;
  const double p_n = of.b_n / joint.gap;
  const double p_t = of.b_t / joint.gap;
  const double f_n = l_nn + of.a_t * p_n;
  const double f_t = l_nt + of.a_t * p_t;

  local.normal = normal;
  local.shares = SharesOf(gradients, joint);
  local.n = joint.magnitude;
  local.nn = of.a_n / local.n;
  local.nt = local.n * p_n;
  local.tt = local.n * p_t;
  // Of one channel, f_n = n nnn + nn^2 + 2 nt^2 and f_t = n nnt + nn nt + 2 nt tt.
  local.nnn = (f_n - local.nn * local.nn - 2 * local.nt * local.nt) / local.n;
  local.nnt = (f_t - local.nn * local.nt - 2 * local.nt * local.tt) / local.n;
  return local;
}

}  // namespace limn
