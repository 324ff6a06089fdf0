// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/orientation_mask.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// An edge through the middle of the image under this angle, edgels 1 px apart.
class OrientationMaskTest : public ::testing::TestWithParam<double> {
 protected:
  Eigen::Vector2d Direction() const { return {std::cos(GetParam()), std::sin(GetParam())}; }
  Eigen::Vector2d Normal() const { return {-Direction().y(), Direction().x()}; }

  OrientationMask MakeMask(bool usable) const {
    std::vector<Edgel> edgels;
    for (int k = -100; k <= 100; ++k) {
      edgels.push_back(testing::MakeEdgel(middle_ + k * Direction(), GetParam()));
    }
    return OrientationMask(testing::MakeEdgeMap(view_, edgels),
                           std::vector<bool>(edgels.size(), usable), view_.region, SupportGate());
  }

  static bool Supports(const OrientationMask& mask, const Eigen::Vector2d& at, double angle) {
    return mask.Supports(at.x(), at.y(), std::cos(angle), std::sin(angle));
  }

  const View view_ = testing::LookAt({5, 0, 0}, {0, 0, 0});
  const Eigen::Vector2d middle_{320.3, 240.6};
};

TEST_P(OrientationMaskTest, SupportsAlongTheEdge) {
  const OrientationMask mask = MakeMask(true);
  for (double k = -90; k <= 90; k += 0.37) {
    const Eigen::Vector2d at = middle_ + k * Direction();
    EXPECT_TRUE(Supports(mask, at, GetParam())) << at.transpose();
    EXPECT_TRUE(Supports(mask, at, GetParam() + M_PI)) << at.transpose();
  }
}

TEST_P(OrientationMaskTest, NotThreePixelsAway) {
  const OrientationMask mask = MakeMask(true);
  for (double k = -90; k <= 90; k += 0.37) {
    for (const double side : {-3.0, 3.0}) {
      EXPECT_FALSE(Supports(mask, middle_ + k * Direction() + side * Normal(), GetParam()));
    }
  }
}

TEST_P(OrientationMaskTest, NotAcrossTheEdge) {
  const OrientationMask mask = MakeMask(true);
  for (double k = -90; k <= 90; k += 0.37) {
    for (const double turn : {M_PI / 2, M_PI / 4, -M_PI / 4}) {
      EXPECT_FALSE(Supports(mask, middle_ + k * Direction(), GetParam() + turn));
    }
  }
}

TEST_P(OrientationMaskTest, UnusableEdgelsSupportNothing) {
  const OrientationMask mask = MakeMask(false);
  EXPECT_FALSE(Supports(mask, middle_, GetParam()));
}

TEST_P(OrientationMaskTest, OutsideTheImageIsNoSupport) {
  const OrientationMask mask = MakeMask(true);
  EXPECT_FALSE(Supports(mask, {-50, 240}, GetParam()));
  EXPECT_FALSE(Supports(mask, {320, 1e6}, GetParam()));
}

// Also at the borders of the image, whose tiles it cuts.
TEST(OrientationMaskTilesTest, EveryPixelHasItsOwnBits) {
  const View view = testing::LookAt({5, 0, 0}, {0, 0, 0});
  const int cols = static_cast<int>(view.region.max_px.x());
  const int rows = static_cast<int>(view.region.max_px.y());
  for (const Eigen::Vector2i& pixel :
       {Eigen::Vector2i(2, 2), {cols, rows}, {7, 8}, {8, 7}, {303, 200}, {cols, 64}}) {
    const EdgeMap edge_map =
        testing::MakeEdgeMap(view, {testing::MakeEdgel(pixel.cast<double>(), 0.1)});
    const SupportGate gate{0.4, 0.4, 0.26};
    const OrientationMask mask(edge_map, {true}, view.region, gate);
    int num_supported = 0;
    for (int row = 2; row <= rows; ++row) {
      for (int col = 2; col <= cols; ++col) num_supported += mask.Supports(col, row, 1, 0.1);
    }
    EXPECT_EQ(num_supported, 1) << pixel.transpose();
    EXPECT_TRUE(mask.Supports(pixel.x(), pixel.y(), 1, 0.1)) << pixel.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, OrientationMaskTest,
                         ::testing::Values(0.0, 0.2, M_PI / 4, 1.1, M_PI / 2, 2.0, 2.6, -0.05));

TEST(OrientationMaskBinTest, BinsAreEqualSectors) {
  for (int i = 0; i < 3200; ++i) {
    const double angle = M_PI * (i + 0.5) / 3200;
    const double in_bins = angle / (M_PI / OrientationMask::kNumBins);
    const double to_border = std::abs(in_bins - std::round(in_bins)) * M_PI / 16;
    if (to_border < 0.006) continue;  // the bin's angle is approximate
    const int expected = static_cast<int>(in_bins);
    EXPECT_EQ(OrientationMask::Bin(std::cos(angle), std::sin(angle)), expected) << angle;
    EXPECT_EQ(OrientationMask::Bin(-3 * std::cos(angle), -3 * std::sin(angle)), expected) << angle;
  }
}

}  // namespace
}  // namespace limn
