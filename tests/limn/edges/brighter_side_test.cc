// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/brighter_side.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_image.h"

namespace limn {
namespace {

// Bright on the right of x = 30.
Image Step() {
  Image image = testing::ConstantImage(60, 40, {50, 60, 70});
  testing::Paint(testing::HalfPlane({30, 0}, {1, 0}), {110, 120, 130}, &image);
  return image;
}

Edgel At(double x, double y, double tangent_rad) {
  Edgel edgel;
  edgel.position_px = {x, y};
  edgel.tangent_rad = tangent_rad;
  return edgel;
}

TEST(BrighterSide, IsThatOfTheNormal) {
  const Image image = Step();
  EXPECT_NEAR(BrighterSide(image, At(30, 20, M_PI / 2)), 60, 1);
  EXPECT_NEAR(BrighterSide(image, At(30, 20, -M_PI / 2)), -60, 1);
  EXPECT_NEAR(BrighterSide(image, At(30, 20, 0)), 0, 1e-6);
  EXPECT_NEAR(BrighterSide(image, At(30, -1, M_PI / 2)), 60, 1);
}

TEST(BrighterSide, EdgelsAgreeWithTheirNeighbors) {
  Image image = Step();
  // The contrast is the other way around at one edgel.
  testing::Paint(testing::Stroke({26, 20}, {34, 20}, 1.2), {80, 80, 80}, &image);
  testing::Paint(testing::Stroke({24, 20}, {30, 20}, 1.2), {90, 90, 90}, &image);
  EXPECT_LT(BrighterSide(image, At(30, 20, M_PI / 2)), 0);
  std::vector<Edgel> edgels;
  for (int y = 15; y <= 25; ++y) edgels.push_back(At(30, y, y % 2 == 0 ? M_PI / 2 : -M_PI / 2));
  DirectByBrightness(image, &edgels);
  for (const Edgel& edgel : edgels) EXPECT_NEAR(edgel.tangent_rad, M_PI / 2, 1e-9);
}

}  // namespace
}  // namespace limn
