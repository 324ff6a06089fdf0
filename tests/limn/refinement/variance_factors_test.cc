// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/variance_factors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/refinement/curve_fit.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr int kNumSegments = 20;
constexpr int kMiddle = kNumSegments / 2;
// Control points are 3 px apart: this many segments are within 6 px of one.
constexpr int kNumNear = 4;
// Views that say beforehand that the weights are right, and degrees of freedom that go to the
// curve.
constexpr double kPriorViews = 4;
constexpr double kFreedoms = 2;

// A straight link with one sample per segment, at which every view has an edgel. The views are
// numbered as their residuals.
struct Scene {
  explicit Scene(const std::vector<double>& residuals_px) {
    control.links.emplace_back();
    for (int k = 0; k <= kNumSegments; ++k) {
      control.links[0].points.push_back(k);
      control.position.push_back(Eigen::Vector3d(3 * k, 0, 0));
      control.footprint.push_back(1);
      if (k > 0 && k < kNumSegments) control.bends.push_back({k - 1, k, k + 1});
    }
    for (int s = 0; s < kNumSegments; ++s) {
      FitSample sample;
      sample.segment = s;
      sample.t = 0.5;
      for (size_t v = 0; v < residuals_px.size(); ++v) {
        const double weight = 1 / ResidualVariance(Edgel());
        sample.pulls.push_back(
            {{static_cast<ViewId>(v), 0}, Edgel(), weight, residuals_px[v], true});
      }
      samples().push_back(sample);
    }
  }

  std::vector<double> Factors() const { return VarianceFactors(RefinementOptions(), control); }

  // Of the mean residuals, by the definition in the header.
  static double ExpectedFactor(const std::vector<double>& residuals_px) {
    const double variance = ResidualVariance(Edgel()) / kNumNear;
    double chi_square = 0;
    for (const double residual : residuals_px) chi_square += residual * residual / variance;
    const double freedoms = static_cast<double>(residuals_px.size()) - kFreedoms;
    return (kPriorViews + chi_square) / (kPriorViews + freedoms);
  }

  std::vector<FitSample>& samples() { return control.links[0].samples; }

  ControlGraph control;
};

TEST(VarianceFactorsTest, WhereAllViewsAgreeNothingGrows) {
  for (const double factor : Scene({0, 0, 0, 0, 0}).Factors()) EXPECT_EQ(factor, 1);
}

TEST(VarianceFactorsTest, ViewsAreTheSamples) {
  const std::vector<double> residuals = {0.6, -0.6, 0.5, -0.5, 0.4, -0.4};
  const Scene scene(residuals);
  ASSERT_GT(Scene::ExpectedFactor(residuals), 2);
  EXPECT_NEAR(scene.Factors()[kMiddle], Scene::ExpectedFactor(residuals), 1e-9);
}

TEST(VarianceFactorsTest, ResidualsAreSignedBySidesOfTheLink) {
  // The same offset of the edge, seen with the brighter side to the left and to the right in turn.
  const std::vector<double> residuals = {0.6, -0.6, 0.5, -0.5, 0.4, -0.4};
  Scene scene(residuals);
  for (size_t s = 0; s < scene.samples().size(); s += 2) {
    for (EdgelPull& pull : scene.samples()[s].pulls) {
      pull.bright_left = false;
      pull.residual_px = -pull.residual_px;
    }
  }
  EXPECT_NEAR(scene.Factors()[kMiddle], Scene::ExpectedFactor(residuals), 1e-9);
}

TEST(VarianceFactorsTest, BendsMultiplyWhatIsNearThem) {
  Scene scene({0, 0, 0, 0, 0});
  scene.control.position[kMiddle].y() = 1;
  double largest = 0;
  for (const auto& bend : scene.control.bends) {
    largest = std::max(largest, SquaredBend(bend, RefinementOptions(), scene.control));
  }
  ASSERT_GT(largest, 1);
  const std::vector<double> factors = scene.Factors();
  EXPECT_NEAR(factors[kMiddle], 1 + largest, 1e-9);
  EXPECT_NEAR(factors[kMiddle + 2], 1 + largest, 1e-9);
  EXPECT_EQ(factors[kMiddle + 4], 1);
}

TEST(VarianceFactorsTest, LinksThatWereNotFittedSayNothing) {
  Scene scene({0.6, -0.6, 0.5, -0.5, 0.4, -0.4});
  scene.control.links[0].frozen = true;
  for (const double factor : scene.Factors()) EXPECT_EQ(factor, 1);
}

}  // namespace
}  // namespace limn
