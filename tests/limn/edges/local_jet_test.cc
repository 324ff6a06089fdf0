// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/local_jet.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector2d;

// A cubic: its derivatives at the origin.
struct Cubic {
  Jet at_origin;

  Jet At(const Vector2d& p) const {
    const Jet& o = at_origin;
    const double x = p.x();
    const double y = p.y();
    Jet jet = o;
    jet.x += o.xx * x + o.xy * y + o.xxx * x * x / 2 + o.xxy * x * y + o.xyy * y * y / 2;
    jet.y += o.xy * x + o.yy * y + o.xxy * x * x / 2 + o.xyy * x * y + o.yyy * y * y / 2;
    jet.xx += o.xxx * x + o.xxy * y;
    jet.xy += o.xxy * x + o.xyy * y;
    jet.yy += o.xyy * x + o.yyy * y;
    return jet;
  }
};

const std::array<Cubic, 3> kColors = {
    Cubic{{100, 5, 2, .3, -.8, .5, -1.1, .4, .2, -.6}},
    Cubic{{10, -3, .5, .9, .2, -.3, -.7, -.2, .5, .3}},
    Cubic{{-20, 1, 4, -.4, .6, .1, .8, .3, -.9, .2}},
};

ChannelGradients GradientsAt(const Vector2d& p) {
  ChannelGradients gradients;
  for (size_t k = 0; k < 3; ++k) {
    const Jet jet = kColors[k].At(p);
    gradients[k] = {jet.x, jet.y};
  }
  return gradients;
}

double SquaredMagnitude(const Vector2d& p) {
  const double magnitude = JoinGradients(GradientsAt(p)).magnitude;
  return magnitude * magnitude;
}

Vector2d GradientOf(const auto& function, const Vector2d& p) {
  constexpr double kStep = 1e-4;
  const Vector2d dx(kStep, 0);
  const Vector2d dy(0, kStep);
  return Vector2d(function(p + dx) - function(p - dx), function(p + dy) - function(p - dy)) /
         (2 * kStep);
}

TEST(LocalJet, JointDerivativesAgreeWithDifferences) {
  const auto edge_function = [](const Vector2d& p) {
    return GradientOf(SquaredMagnitude, p).dot(JoinGradients(GradientsAt(p)).normal);
  };
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(.4, -.2), Vector2d(-.3, .5)}) {
    const LocalJet local =
        AlongJointGradient({kColors[0].At(p), kColors[1].At(p), kColors[2].At(p)});
    const Vector2d n = local.normal;
    const Vector2d t(-n.y(), n.x());
    EXPECT_NEAR(local.n * local.n, SquaredMagnitude(p), 1e-9);
    EXPECT_NEAR(2 * local.n * local.nn, GradientOf(SquaredMagnitude, p).dot(n), 1e-5);
    const auto turn = [&](const Vector2d& q) {
      return std::asin(t.dot(JoinGradients(GradientsAt(q)).normal));
    };
    const Vector2d turns = GradientOf(turn, p);
    EXPECT_NEAR(local.nt / local.n, turns.dot(n), 1e-6);
    EXPECT_NEAR(local.tt / local.n, turns.dot(t), 1e-6);
    const Vector2d f = GradientOf(edge_function, p) / 2;
    EXPECT_NEAR(local.n * local.nnn + local.nn * local.nn + 2 * local.nt * local.nt, f.dot(n),
                1e-4);
    EXPECT_NEAR(local.n * local.nnt + local.nn * local.nt + 2 * local.nt * local.tt, f.dot(t),
                1e-4);
    EXPECT_EQ(local.value, kColors[0].at_origin.value);
    EXPECT_NEAR(local.shares[0] + local.shares[1] + local.shares[2], 1, 1e-12);
  }
}

TEST(LocalJet, MultiplesOfOneChannelHaveItsEdge) {
  const std::array<double, 3> factors = {2, -1, 2};  // the norm is 3
  const Jet one = kColors[0].at_origin;
  std::array<Jet, 3> jets;
  for (size_t k = 0; k < 3; ++k) {
    const double f = factors[k];
    jets[k] = {f * one.value, f * one.x,   f * one.y,   f * one.xx,  f * one.xy,
               f * one.yy,    f * one.xxx, f * one.xxy, f * one.xyy, f * one.yyy};
  }
  const LocalJet expected = AlongGradient(one);
  const LocalJet local = AlongJointGradient(jets);
  EXPECT_NEAR((local.normal - expected.normal).norm(), 0, 1e-12);
  EXPECT_NEAR(local.n, 3 * expected.n, 1e-9);
  EXPECT_NEAR(local.nn, 3 * expected.nn, 1e-9);
  EXPECT_NEAR(local.nt, 3 * expected.nt, 1e-9);
  EXPECT_NEAR(local.tt, 3 * expected.tt, 1e-9);
  EXPECT_NEAR(local.nnn, 3 * expected.nnn, 1e-9);
  EXPECT_NEAR(local.nnt, 3 * expected.nnt, 1e-9);
  EXPECT_NEAR(local.shares[1], 1. / 9, 1e-12);
}

TEST(LocalJet, AxisAlignedGradients) {
  // Where one of the two forms of the eigenvector is 0 / 0.
  for (const Vector2d& g : {Vector2d(3, 0), Vector2d(-3, 0), Vector2d(0, 3), Vector2d(0, -3)}) {
    const JointGradient joint = JoinGradients({g, Vector2d::Zero(), Vector2d::Zero()});
    EXPECT_EQ(joint.normal, g.normalized());
    EXPECT_EQ(joint.magnitude, 3);
  }
}

TEST(LocalJet, NoDirectionWithoutAGradient) {
  EXPECT_EQ(AlongJointGradient({}).n, 0);
  EXPECT_EQ(AlongGradient({}).n, 0);
}

}  // namespace
}  // namespace limn
