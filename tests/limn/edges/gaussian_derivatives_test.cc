// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/gaussian_derivatives.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr double kDerivativeSigma = 1.5;

// A cubic polynomial and its derivatives after Gaussian smoothing, which adds sigma^2 / 2 times the
// Laplacian (exactly, for a cubic).
double CubicImage(double x, double y) {
  return 0.02 * x * x * x - 0.03 * x * x * y + 0.01 * x * y * y + 0.04 * y * y * y + 0.3 * x * y;
}

PaddedPlane CubicPlane(int size, double center) {
  std::vector<float> values;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      values.push_back(static_cast<float>(CubicImage(x - center, y - center)));
    }
  }
  return MakePaddedPlane(values, size, size, GaussianPadding(kDerivativeSigma, 1));
}

TEST(SubpixelDerivatives, CubicAtSubpixelPositions) {
  const double center = 16;
  const PaddedPlane plane = CubicPlane(33, center);
  const GaussianKernels kernels(kDerivativeSigma, 1);
  const SubpixelDerivatives derivatives(plane, kernels, Eigen::Array2d::Ones());
  for (const double x : {-0.5, -0.1875, 0.0, 0.375}) {
    for (const double y : {-0.46875, 0.0, 0.25}) {
      const Jet jet = derivatives.At({center + x, center + y});
      const double s2 = kDerivativeSigma * kDerivativeSigma;
      EXPECT_NEAR(jet.x,
                  0.06 * x * x - 0.06 * x * y + 0.01 * y * y + 0.3 * y + 0.5 * s2 * (0.12 + 0.02),
                  0.01);
      EXPECT_NEAR(jet.y,
                  -0.03 * x * x + 0.02 * x * y + 0.12 * y * y + 0.3 * x + 0.5 * s2 * (-0.06 + 0.24),
                  0.01);
      EXPECT_NEAR(jet.xx, 0.12 * x - 0.06 * y, 0.01);
      EXPECT_NEAR(jet.xy, -0.06 * x + 0.02 * y + 0.3, 0.01);
      EXPECT_NEAR(jet.yy, 0.02 * x + 0.24 * y, 0.01);
      EXPECT_NEAR(jet.xxx, 0.12, 0.01);
      EXPECT_NEAR(jet.xxy, -0.06, 0.01);
      EXPECT_NEAR(jet.xyy, 0.02, 0.01);
      EXPECT_NEAR(jet.yyy, 0.24, 0.01);
    }
  }
}

TEST(SubpixelDerivatives, BrightConstantHasNoDerivatives) {
  const PaddedPlane plane =
      MakePaddedPlane(std::vector<float>(400, 255.f), 20, 20, GaussianPadding(kDerivativeSigma, 1));
  const GaussianKernels kernels(kDerivativeSigma, 1);
  const Jet jet = SubpixelDerivatives(plane, kernels, Eigen::Array2d::Ones()).At({10.375, 9.6875});
  EXPECT_EQ(jet.value, 255);
  EXPECT_EQ(jet.x, 0);
  EXPECT_EQ(jet.yy, 0);
  EXPECT_EQ(jet.xxx, 0);
}

TEST(SubpixelDerivatives, NearestNode) {
  const PaddedPlane plane = CubicPlane(33, 16);
  const GaussianKernels kernels(kDerivativeSigma, 1.5);
  const Eigen::Array2d scale(1.5, 1.5);
  const SubpixelDerivatives derivatives(plane, kernels, scale);
  for (const double coordinate : {-0.7, -0.5, 0.0, 0.01, 7.26, 40.995}) {
    const Eigen::Vector2d node = derivatives.NearestNode({coordinate, 3});
    EXPECT_LE(std::abs(node.x() - coordinate), 0.5 * 1.5 / GaussianKernels::kNodesPerPx);
    const double steps = ((node.x() + 0.5) / 1.5 - 0.5) * GaussianKernels::kNodesPerPx;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
  }
}

TEST(SmoothedGradient, AgreesWithSubpixelDerivatives) {
  const PaddedPlane plane = CubicPlane(33, 16);
  const GradientField field = SmoothedGradient(plane, GaussianKernels(kDerivativeSigma, 1), 33, 33);
  const GaussianKernels kernels(kDerivativeSigma, 1);
  const SubpixelDerivatives derivatives(plane, kernels, Eigen::Array2d::Ones());
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      const Jet jet = derivatives.At(Eigen::Vector2d(x, y));
      EXPECT_NEAR(field.dx[y * 33 + x], jet.x, 0.03);
      EXPECT_NEAR(field.dy[y * 33 + x], jet.y, 0.03);
      EXPECT_NEAR(field.smooth[y * 33 + x], jet.value, 0.05);
    }
  }
}

// Pixels of the view are finer than those of the plane: places, slopes and bends are in theirs.
TEST(SmoothedGradient, InPixelsOfTheView) {
  constexpr double kScale = 2;
  const PaddedPlane plane = CubicPlane(33, 16);
  const GaussianKernels kernels(kDerivativeSigma, 1);
  const GaussianKernels finer(kScale * kDerivativeSigma, kScale);
  const GradientField field = SmoothedGradient(plane, finer, 66, 66);
  const SubpixelDerivatives in_plane(plane, kernels, Eigen::Array2d::Ones());
  const SubpixelDerivatives in_view(plane, finer, Eigen::Array2d(kScale, kScale));
  for (const int v : {0, 20, 21, 65}) {
    for (const int u : {0, 32, 33, 65}) {
      const Eigen::Vector2d place((u + 0.5) / kScale - 0.5, (v + 0.5) / kScale - 0.5);
      const Jet expected = in_plane.At(place);
      const Jet jet = in_view.At(Eigen::Vector2d(u, v));
      EXPECT_NEAR(jet.value, expected.value, 1e-4);
      EXPECT_NEAR(jet.x, expected.x / kScale, 1e-4);
      EXPECT_NEAR(jet.xy, expected.xy / kScale / kScale, 1e-4);
      EXPECT_NEAR(jet.yyy, expected.yyy / kScale / kScale / kScale, 1e-4);
      EXPECT_NEAR(field.dx[v * 66 + u], expected.x / kScale, 0.03);
      EXPECT_NEAR(field.dy[v * 66 + u], expected.y / kScale, 0.03);
    }
  }
}

}  // namespace
}  // namespace limn
