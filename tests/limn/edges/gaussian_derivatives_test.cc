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
  return MakePaddedPlane(values, size, size, GaussianPadding(kDerivativeSigma));
}

TEST(SubpixelDerivatives, CubicAtSubpixelPositions) {
  const double center = 16;
  const PaddedPlane plane = CubicPlane(33, center);
  const SubpixelDerivatives derivatives(plane, kDerivativeSigma);
  for (const double x : {-0.5, -0.1875, 0.0, 0.375}) {
    for (const double y : {-0.46875, 0.0, 0.25}) {
      const Jet jet = derivatives.At(center + x, center + y);
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
      MakePaddedPlane(std::vector<float>(400, 255.f), 20, 20, GaussianPadding(kDerivativeSigma));
  const Jet jet = SubpixelDerivatives(plane, kDerivativeSigma).At(10.375, 9.6875);
  EXPECT_EQ(jet.value, 255);
  EXPECT_EQ(jet.x, 0);
  EXPECT_EQ(jet.yy, 0);
  EXPECT_EQ(jet.xxx, 0);
}

TEST(SubpixelDerivatives, NearestNode) {
  for (const double coordinate : {-0.7, -0.5, 0.0, 0.01, 7.26, 4000.995}) {
    const double node = SubpixelDerivatives::NearestNode(coordinate);
    EXPECT_LE(std::abs(node - coordinate), 0.5 / SubpixelDerivatives::kNodesPerPx);
    EXPECT_EQ(std::floor(node * SubpixelDerivatives::kNodesPerPx),
              node * SubpixelDerivatives::kNodesPerPx);
  }
}

TEST(SmoothedGradient, AgreesWithSubpixelDerivatives) {
  const PaddedPlane plane = CubicPlane(33, 16);
  const GradientField field = SmoothedGradient(plane, kDerivativeSigma);
  const SubpixelDerivatives derivatives(plane, kDerivativeSigma);
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      const Jet jet = derivatives.At(x, y);
      EXPECT_NEAR(field.dx[y * 33 + x], jet.x, 0.03);
      EXPECT_NEAR(field.dy[y * 33 + x], jet.y, 0.03);
      EXPECT_NEAR(field.smooth[y * 33 + x], jet.value, 0.05);
    }
  }
}

}  // namespace
}  // namespace limn
